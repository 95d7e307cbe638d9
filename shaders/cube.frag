#version 330 core
// An axis-aligned cube with its corners on the ball of v_radius and edges softened by the light.

flat in float v_radius;

#include "view.glsl"
#include "lighting.glsl"
#include "covered.glsl"

// Where a ray, in the axes of the cube, enters and leaves it.
vec2 crossed(vec3 closest, vec3 direction, float half_side) {
    vec3 inverse = 1.0 / (direction + 1e-20);  // no 0 * infinity
    vec3 middle = -closest * inverse;
    vec3 span = half_side * abs(inverse);
    vec3 enters = middle - span;
    vec3 leaves = middle + span;
    return vec2(max(enters.x, max(enters.y, enters.z)), min(leaves.x, min(leaves.y, leaves.z)));
}

float surface(vec3 closest, vec3 direction, out vec3 normal, out float coverage) {
    float half_side = v_radius * inversesqrt(3.0);
    vec3 from = closest * u_rotation;
    vec3 along = direction * u_rotation;
    vec2 range = crossed(from, along, half_side);
    coverage = covered_by(range.y - range.x);
    float distance = min(range.x, 0.5 * (range.x + range.y));
    vec3 part = (from + distance * along) / half_side;
    vec3 squared = part * part;
    vec3 rounded = part * squared * squared * squared;  // the normal of a face, except near the edges
    normal = u_rotation * normalize(rounded);
    return distance;
}

#include "impostor.glsl"
