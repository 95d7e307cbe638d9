// The part of a pixel that a convex body covers. `stretch`: length of the ray in the body, negative where it misses; it
// changes evenly near the outline.
float covered_by(float stretch) {
    float change = length(vec2(dFdx(stretch), dFdy(stretch)));
    return clamp(stretch / max(change, 1e-20) + 0.5, 0.0, 1.0);
}
