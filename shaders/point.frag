#version 330 core
// A small ball: lit like a large one, flat in depth, with its outline smoothed by the distance to the pixel.

flat in vec3 v_colour;
flat in float v_radius;

uniform float u_least_coverage;  // smallest coverage of a pixel that is drawn

#include "view.glsl"
#include "lighting.glsl"

out vec4 f_colour;

void main() {
    vec2 place = (gl_PointCoord - 0.5) * vec2(1.0, -1.0) * (2.0 * v_radius + 1.0);  // pixels from the centre, up
    float off = length(place);
    float coverage = clamp(v_radius - off + 0.5, 0.0, 1.0);
    if (coverage <= u_least_coverage) discard;
    vec2 across = place / max(v_radius, off);
    vec3 normal = vec3(across, sqrt(max(1.0 - dot(across, across), 0.0)));
    f_colour = vec4(lit(v_colour, normal, vec3(0.0, 0.0, 1.0)), coverage);
}
