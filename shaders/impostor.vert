#version 330 core
// One quad per particle that just covers a ball of u_radius, or of the smallest radius that is drawn.

layout(location = 0) in vec3 a_centre;
layout(location = 1) in vec4 a_colour;  // alpha: part of u_radius that the ball has

uniform float u_radius;
uniform float u_least_radius;  // pixels

#include "view.glsl"

out vec3 v_direction;     // of the ray through the fragment, in the eye's space, z = -1
flat out vec3 v_centre;   // of the ball, in the eye's space
flat out vec3 v_colour;
flat out float v_radius;
flat out float v_scale;   // pixels of a length of 1 at the centre

// The range of across/ahead that the ball covers, in the plane of that direction and the line of sight.
vec2 covered(float across, float ahead) {
    float from_eye = across * across + ahead * ahead;
    float root = v_radius * sqrt(max(from_eye - v_radius * v_radius, 0.0));
    return vec2(across * ahead - root, across * ahead + root) / (ahead * ahead - v_radius * v_radius);
}

void main() {
    v_centre = seen(a_centre);
    v_colour = a_colour.rgb;
    float ahead = -v_centre.z;
    v_scale = u_pixels / ahead;
    float own_radius = a_colour.a * u_radius;
    v_radius = max(own_radius, u_least_radius / v_scale);
    v_direction = vec3(0.0);
    if (ahead <= 1.01 * own_radius) {  // the eye is inside, or it is not in front of the eye
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    vec2 horizontal = covered(v_centre.x, ahead);
    vec2 vertical = covered(v_centre.y, ahead);
    float margin = 1.0 / u_pixels;
    bool right = (gl_VertexID & 1) != 0;
    bool upper = (gl_VertexID & 2) != 0;
    v_direction = vec3(right ? horizontal.y + margin : horizontal.x - margin,
                       upper ? vertical.y + margin : vertical.x - margin, -1.0);
    gl_Position = u_clip * vec4(v_direction * (ahead - v_radius), 1.0);
    // All fragments write their own depth; the planes must not cut off the quad.
    gl_Position.z = 0.0;
}
