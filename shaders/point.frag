#version 330 core
// A small ball: lit like a large one, flat in depth, its outline smoothed by the samples it covers.
#extension GL_ARB_sample_shading : enable

flat in vec3 v_colour;
flat in float v_radius;

uniform vec2 u_samples[16];
uniform int u_sample_count;

#include "view.glsl"
#include "lighting.glsl"

out vec4 f_colour;

void main() {
    vec2 place = (gl_PointCoord - 0.5) * vec2(1.0, -1.0) * (2.0 * v_radius + 1.0);  // pixels from the centre, up
#ifdef GL_ARB_sample_shading
    int mask = 0;
    for (int i = 0; i < u_sample_count; ++i) {
        vec2 at = place + u_samples[i];
        if (dot(at, at) <= v_radius * v_radius) mask |= 1 << i;
    }
    if (mask == 0) discard;
    gl_SampleMask[0] = mask;
#else
    if (dot(place, place) > v_radius * v_radius) discard;
#endif
    vec2 across = place / max(v_radius, 1.0);
    float squared = min(dot(across, across), 1.0);
    vec3 normal = normalize(vec3(across, sqrt(1.0 - squared)));
    f_colour = vec4(lit(v_colour, normal, vec3(0.0, 0.0, 1.0)), 1.0);
}
