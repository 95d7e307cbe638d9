#version 330 core
// Dear ImGui's vertices: units from the top left corner of the display.

layout(location = 0) in vec2 a_position;
layout(location = 1) in vec2 a_texture_position;
layout(location = 2) in vec4 a_colour;

uniform vec2 u_origin;
uniform vec2 u_size;

out vec2 v_texture_position;
out vec4 v_colour;

void main() {
    v_texture_position = a_texture_position;
    v_colour = a_colour;
    vec2 part = (a_position - u_origin) / u_size;
    gl_Position = vec4(2.0 * part.x - 1.0, 1.0 - 2.0 * part.y, 0.0, 1.0);
}
