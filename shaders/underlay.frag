#version 330 core
// What a picture shows so far, again: pixel by pixel.

uniform sampler2D u_picture;

out vec4 f_colour;

void main() { f_colour = texelFetch(u_picture, ivec2(gl_FragCoord.xy), 0); }
