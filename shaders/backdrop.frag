#version 330 core

in float v_height;

uniform vec3 u_bottom;
uniform vec3 u_top;

out vec4 f_colour;

void main() { f_colour = vec4(mix(u_bottom, u_top, v_height), 1.0); }
