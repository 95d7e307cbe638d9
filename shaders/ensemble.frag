#version 330 core

in vec2 v_place;
flat in float v_radius;
flat in vec4 v_colour;

out vec4 f_colour;

void main() {
    float coverage = clamp(v_radius - length(v_place) + 0.5, 0.0, 1.0);
    if (coverage <= 0.0) discard;
    f_colour = vec4(v_colour.rgb, v_colour.a * coverage);
}
