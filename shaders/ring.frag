#version 330 core

in vec2 v_place;
flat in float v_radius;
flat in vec4 v_colour;

uniform float u_width;

out vec4 f_colour;

void main() {
    float off = abs(length(v_place) - v_radius) - 0.5 * u_width;
    float coverage = clamp(0.5 - off, 0.0, 1.0);
    if (coverage <= 0.0) discard;
    f_colour = vec4(v_colour.rgb, v_colour.a * coverage);
}
