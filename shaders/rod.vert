#version 330 core
// One quad per rod (spring, line of an axis), turned to the eye; never thinner than u_least_width pixels.

layout(location = 0) in vec3 a_start;
layout(location = 1) in vec3 a_end;
layout(location = 2) in vec4 a_colour;

uniform float u_radius;       // 0: a line
uniform float u_least_width;  // pixels

#include "view.glsl"

out vec4 v_colour;
out float v_across;         // -1 .. 1 from side to side
out float v_roundness;      // 0 where the rod is too thin to show that it is round
out vec3 v_side;            // in the eye's space, of length 1
out vec3 v_position;

void main() {
    vec3 start = seen(a_start);
    vec3 end = seen(a_end);
    vec3 position = (gl_VertexID & 1) != 0 ? end : start;
    v_side = normalize(cross(end - start, -position) + vec3(1e-30, 0.0, 0.0));
    v_across = (gl_VertexID & 2) != 0 ? 1.0 : -1.0;
    float least_radius = 0.5 * u_least_width * max(-position.z, 0.0) / u_pixels;
    float radius = max(u_radius, least_radius);
    v_position = position + v_across * radius * v_side;
    v_roundness = smoothstep(2.0, 6.0, 2.0 * radius * u_pixels / max(-position.z, 1e-30));
    // A rod too thin to be drawn so is drawn paler instead; a plain line has no thickness of its own.
    float thinness = u_radius > 0.0 ? u_radius / radius : 1.0;
    v_colour = vec4(a_colour.rgb, a_colour.a * mix(1.0, thinness, 0.6));
    gl_Position = u_clip * vec4(v_position, 1.0);
}
