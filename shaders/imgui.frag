#version 330 core

in vec2 v_texture_position;
in vec4 v_colour;

uniform sampler2D u_texture;

out vec4 f_colour;

void main() { f_colour = v_colour * texture(u_texture, v_texture_position); }
