#version 330 core
// One triangle over the whole framebuffer.

uniform vec2 u_rows;  // lower and upper edge of the tile in the whole picture, 0 bottom .. 1 top

out float v_height;

void main() {
    vec2 corner = vec2((gl_VertexID & 1) != 0 ? 3.0 : -1.0, (gl_VertexID & 2) != 0 ? 3.0 : -1.0);
    v_height = mix(u_rows.x, u_rows.y, 0.5 * corner.y + 0.5);
    gl_Position = vec4(corner, 0.0, 1.0);
}
