// Draws a convex body inside its quad. The shader that includes this defines:
//     bool hit(vec3 closest, vec3 direction)    does this ray meet the body?
//     float surface(vec3 closest, vec3 direction, out vec3 normal)
//         how far along the ray from `closest` its surface is (negative: nearer), and the normal in the eye's space
// A ray is given relative to the body's centre by its point closest to that centre, so that nothing is lost far away.

in vec3 v_direction;
flat in vec3 v_centre;
flat in vec3 v_colour;

uniform vec2 u_samples[16];  // where the samples of a pixel lie, from its centre, in pixels
uniform int u_sample_count;

out vec4 f_colour;

vec3 closest_to_centre(vec3 direction) {
    return direction * (dot(direction, v_centre) / dot(direction, direction)) - v_centre;
}

bool meets(vec3 direction) { return hit(closest_to_centre(direction), direction); }

// The direction to shade by: the mean of the samples' that meet the body. Covers just these samples.
vec3 cover() {
#ifdef GL_ARB_sample_shading
    vec3 across = dFdx(v_direction);
    vec3 upwards = dFdy(v_direction);
    vec3 sum = vec3(0.0);
    int mask = 0;
    for (int i = 0; i < u_sample_count; ++i) {
        vec3 direction = v_direction + u_samples[i].x * across + u_samples[i].y * upwards;
        if (meets(direction)) {
            mask |= 1 << i;
            sum += direction;
        }
    }
    if (mask == 0) discard;
    gl_SampleMask[0] = mask;
    return sum / -sum.z;
#else
    if (!meets(v_direction)) discard;
    return v_direction;
#endif
}

void main() {
    vec3 direction = cover();
    vec3 closest = closest_to_centre(direction);
    vec3 unit = normalize(direction);
    vec3 normal;
    vec3 point = v_centre + closest + unit * surface(closest, unit, normal);
    vec2 depth = (u_clip * vec4(0.0, 0.0, point.z, 1.0)).zw;
    gl_FragDepth = clamp(0.5 * depth.x / depth.y + 0.5, 0.0, 1.0);
    f_colour = vec4(lit(v_colour, normal, -unit), 1.0);
}
