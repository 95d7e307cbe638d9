// Draws a convex body inside its quad. The shader that includes this defines:
//     float surface(vec3 closest, vec3 direction, out vec3 normal, out float coverage)
//         the distance of the body's surface from `closest` along the ray (negative: nearer), the normal in the eye's
//         space, and the part of the pixel that the body covers, which makes its outline smooth
// A ray is given relative to the centre of the body by its point closest to that centre, so that it is exact far away.

in vec3 v_direction;
flat in vec3 v_centre;
flat in vec3 v_colour;

uniform float u_least_coverage;  // smallest coverage of a pixel that is drawn

out vec4 f_colour;

void main() {
    vec3 unit = normalize(v_direction);
    vec3 closest = unit * dot(unit, v_centre) - v_centre;
    vec3 normal;
    float coverage;
    vec3 point = v_centre + closest + unit * surface(closest, unit, normal, coverage);
    if (coverage <= u_least_coverage) discard;
    vec2 depth = (u_clip * vec4(0.0, 0.0, point.z, 1.0)).zw;
    gl_FragDepth = clamp(0.5 * depth.x / depth.y + 0.5, 0.0, 1.0);
    f_colour = vec4(lit(v_colour, normal, -unit), coverage);
}
