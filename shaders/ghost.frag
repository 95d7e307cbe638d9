#version 330 core

in vec2 v_place;
flat in float v_radius;
flat in vec3 v_colour;

uniform float u_width;    // of the outline, in pixels
uniform float u_filled;   // opacity within it
uniform float u_outline;  // of which swatch, all within the particle's disc

out vec4 f_colour;

// Distance from the outline in pixels, negative within.
float off_diamond() { return 0.707 * (abs(v_place.x) + abs(v_place.y) - v_radius); }
float off_circle() { return length(v_place) - v_radius; }
float off_square() { return max(abs(v_place.x), abs(v_place.y)) - 0.707 * v_radius; }
float off_triangle() { return max(0.866 * abs(v_place.x) + 0.5 * v_place.y, -v_place.y) - 0.5 * v_radius; }

float off_outline() {
    if (u_outline < 0.5) return off_diamond();
    if (u_outline < 1.5) return off_circle();
    return u_outline < 2.5 ? off_square() : off_triangle();
}

void main() {
    float off = off_outline();
    float within = clamp(0.5 - off, 0.0, 1.0);
    if (within <= 0.0) discard;
    float outline = clamp(off + u_width + 0.5, 0.0, 1.0);
    f_colour = vec4(v_colour, within * mix(u_filled, 0.95, outline));
}
