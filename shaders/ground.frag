#version 330 core
// Lines every u_step, every fifth one stronger, one pixel wide at any distance. They fade towards the edge of the
// ground, where they are dense, and where the ground is seen from the side.

in vec2 v_place;
in vec3 v_position;

uniform vec2 u_origin;  // place of the lines through 0, from the square's centre
uniform float u_step;
uniform float u_reach;
uniform float u_width;  // pixels
uniform vec3 u_colour;
uniform float u_strength;

#include "view.glsl"

out vec4 f_colour;

// Coverage of lines at integers; `spread` is the number of them in a pixel.
float lines(vec2 place, vec2 spread) {
    vec2 off = abs(fract(place - 0.5) - 0.5) / spread;
    vec2 covered = clamp(0.5 * u_width + 0.5 - off, 0.0, 1.0) * (1.0 - smoothstep(0.15, 0.45, spread));
    return max(covered.x, covered.y);
}

void main() {
    vec2 place = (v_place - u_origin) / u_step;
    vec2 spread = max(fwidth(place), vec2(1e-6));
    float line = max(0.42 * lines(place, spread), 0.9 * lines(place / 5.0, spread / 5.0));
    float rim = 1.0 - smoothstep(0.45, 1.0, length(v_place) / u_reach);
    vec3 to_eye = normalize(-v_position);
    float slant = smoothstep(0.0, 0.12, abs(dot(to_eye, u_rotation[1])));
    f_colour = vec4(u_colour, u_strength * line * rim * slant);
}
