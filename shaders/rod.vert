#version 330 core
// A round rod, lit.

#include "view.glsl"
#include "rod.glsl"

out vec4 v_colour;
out float v_across;         // -1 .. 1 from side to side
out float v_roundness;      // 0 if the rod is too thin for visible shading
out vec3 v_side;            // in the eye's space, of length 1
out vec3 v_position;

void main() {
    RodCorner corner = rod_corner();
    v_colour = vec4(a_colour.rgb, corner.alpha);
    v_across = corner.across;
    v_roundness = smoothstep(2.0, 6.0, corner.diameter);
    v_side = corner.side;
    v_position = corner.position;
    gl_Position = u_clip * vec4(corner.position, 1.0);
}
