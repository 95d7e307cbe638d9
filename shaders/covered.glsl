// How much of its pixel a convex body covers whose ray is inside it for `stretch`, less than nothing where it misses:
// near the outline that changes evenly.
float covered_by(float stretch) {
    float change = length(vec2(dFdx(stretch), dFdy(stretch)));
    return clamp(stretch / max(change, 1e-20) + 0.5, 0.0, 1.0);
}
