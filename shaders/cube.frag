#version 330 core
// A cube along the axes of space, its corners on the ball of u_radius, its edges softened by the light.
#extension GL_ARB_sample_shading : enable

uniform float u_radius;

#include "view.glsl"
#include "lighting.glsl"

// Where a ray in the cube's own axes enters and leaves it.
vec2 crossed(vec3 closest, vec3 direction, float half_side) {
    vec3 inverse = 1.0 / (direction + 1e-20);  // no 0 * infinity
    vec3 middle = -closest * inverse;
    vec3 span = half_side * abs(inverse);
    vec3 enters = middle - span;
    vec3 leaves = middle + span;
    return vec2(max(enters.x, max(enters.y, enters.z)), min(leaves.x, min(leaves.y, leaves.z)));
}

bool hit(vec3 closest, vec3 direction) {
    vec2 range = crossed(closest * u_rotation, direction * u_rotation, u_radius * inversesqrt(3.0));
    return range.x <= range.y;
}

float surface(vec3 closest, vec3 direction, out vec3 normal) {
    float half_side = u_radius * inversesqrt(3.0);
    vec3 from = closest * u_rotation;
    vec3 along = direction * u_rotation;
    float distance = crossed(from, along, half_side).x;
    vec3 part = (from + distance * along) / half_side;
    vec3 squared = part * part;
    vec3 rounded = part * squared * squared * squared;  // nearly a face's normal but for the edges
    normal = u_rotation * normalize(rounded);
    return distance;
}

#include "impostor.glsl"
