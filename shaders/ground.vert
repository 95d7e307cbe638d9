#version 330 core
// The ground: a horizontal square around the scene.

uniform vec3 u_centre;     // relative to the focus
uniform float u_reach;     // half its side

#include "view.glsl"

out vec2 v_place;     // from the square's centre, x and z
out vec3 v_position;  // in the eye's space

void main() {
    v_place = u_reach * vec2((gl_VertexID & 1) != 0 ? 1.0 : -1.0, (gl_VertexID & 2) != 0 ? 1.0 : -1.0);
    v_position = seen(u_centre + vec3(v_place.x, 0.0, v_place.y));
    gl_Position = u_clip * vec4(v_position, 1.0);
}
