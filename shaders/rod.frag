#version 330 core

in vec4 v_colour;
in float v_across;
in float v_roundness;
in vec3 v_side;
in vec3 v_position;

#include "view.glsl"
#include "lighting.glsl"

out vec4 f_colour;

void main() {
    vec3 to_eye = normalize(-v_position);
    vec3 side = normalize(v_side);
    vec3 front = normalize(to_eye - side * dot(side, to_eye));
    float across = v_roundness * clamp(v_across, -1.0, 1.0);
    vec3 normal = side * across + front * sqrt(1.0 - across * across);
    f_colour = vec4(mix(u_backdrop, lit(v_colour.rgb, normal, to_eye), v_colour.a), 1.0);
}
