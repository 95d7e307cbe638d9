#version 330 core
// The particles of a run beside the leading one: translucent marks facing the camera.

layout(location = 0) in vec3 a_centre;
layout(location = 1) in vec4 a_colour;  // alpha: part of u_radius that the particle has

uniform float u_radius;
uniform float u_least_radius;  // pixels

#include "view.glsl"

out vec2 v_place;         // pixels from the centre, y up
flat out float v_radius;  // pixels
flat out vec3 v_colour;

void main() {
    vec3 centre = seen(a_centre);
    float pixels = u_pixels / max(-centre.z, 1e-30);
    v_radius = max(a_colour.a * u_radius * pixels, u_least_radius);
    v_colour = a_colour.rgb;
    vec2 corner = vec2((gl_VertexID & 1) != 0 ? 1.0 : -1.0, (gl_VertexID & 2) != 0 ? 1.0 : -1.0);
    v_place = corner * (v_radius + 1.0);
    gl_Position = u_clip * vec4(centre + vec3(v_place / pixels, 0.0), 1.0);
}
