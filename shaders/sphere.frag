#version 330 core
// A ball.

flat in float v_radius;
flat in float v_scale;  // pixels of a length of 1 where the ball is

#include "view.glsl"
#include "lighting.glsl"

float surface(vec3 closest, vec3 direction, out vec3 normal, out float coverage) {
    float off = length(closest);
    coverage = clamp((v_radius - off) * v_scale + 0.5, 0.0, 1.0);
    float along = -sqrt(max(v_radius * v_radius - off * off, 0.0));
    normal = (closest + along * direction) / max(v_radius, off);
    return along;
}

#include "impostor.glsl"
