#version 330 core
// A rod too thin for visible shading across it, or a plain line.

uniform float u_lit;  // 1: a rod under the light; 0: a plain line

#include "view.glsl"
#include "lighting.glsl"
#include "rod.glsl"

out vec3 v_colour;

void main() {
    RodCorner corner = rod_corner();
    vec3 to_eye = normalize(-corner.position);
    vec3 front = normalize(to_eye - corner.side * dot(corner.side, to_eye));
    vec3 colour = mix(a_colour.rgb, lit(a_colour.rgb, front, to_eye), u_lit);
    v_colour = mix(u_backdrop, colour, corner.alpha);
    gl_Position = u_clip * vec4(corner.position, 1.0);
}
