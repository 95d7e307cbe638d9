#version 330 core
// An axis-aligned octahedron with its corners on the ball of v_radius.

flat in float v_radius;

#include "view.glsl"
#include "lighting.glsl"
#include "covered.glsl"

// A face and its opposite are the planes n x = +-v_radius, n one of (1, 1, 1), (1, 1, -1), (1, -1, 1), (-1, 1, 1).
vec4 across_faces(vec3 v) { return vec4(v.x + v.y + v.z, v.x + v.y - v.z, v.x - v.y + v.z, -v.x + v.y + v.z); }

vec2 crossed(vec4 closest, vec4 direction, out vec4 enters) {
    vec4 inverse = 1.0 / (direction + 1e-20);  // no 0 * infinity
    vec4 middle = -closest * inverse;
    vec4 span = v_radius * abs(inverse);
    enters = middle - span;
    vec4 leaves = middle + span;
    return vec2(max(max(enters.x, enters.y), max(enters.z, enters.w)),
                min(min(leaves.x, leaves.y), min(leaves.z, leaves.w)));
}

float surface(vec3 closest, vec3 direction, out vec3 normal, out float coverage) {
    vec3 along = direction * u_rotation;
    vec4 rate = across_faces(along);
    vec4 enters;
    vec2 range = crossed(across_faces(closest * u_rotation), rate, enters);
    coverage = covered_by(range.y - range.x);
    float distance = range.x;
    vec3 face = distance == enters.x   ? -sign(rate.x) * vec3(1.0, 1.0, 1.0)
                : distance == enters.y ? -sign(rate.y) * vec3(1.0, 1.0, -1.0)
                : distance == enters.z ? -sign(rate.z) * vec3(1.0, -1.0, 1.0)
                                       : -sign(rate.w) * vec3(-1.0, 1.0, 1.0);
    normal = u_rotation * normalize(face);
    return min(range.x, 0.5 * (range.x + range.y));
}

#include "impostor.glsl"
