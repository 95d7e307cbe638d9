#version 330 core
// A ball.
#extension GL_ARB_sample_shading : enable

uniform float u_radius;

#include "view.glsl"
#include "lighting.glsl"

bool hit(vec3 closest, vec3 direction) { return dot(closest, closest) <= u_radius * u_radius; }

float surface(vec3 closest, vec3 direction, out vec3 normal) {
    float along = -sqrt(max(u_radius * u_radius - dot(closest, closest), 0.0));
    normal = (closest + along * direction) / u_radius;
    return along;
}

#include "impostor.glsl"
