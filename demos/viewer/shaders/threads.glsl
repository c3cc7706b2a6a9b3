// One crossing of threads, in threads: slopes, and brightness over the mean.
// A thread that arches along x and is round along y, both from -0.5 to 0.5.
Relief thread(float along, float across) {
    float gap = smoothstep(0.28, 0.5, abs(across));
    float dip = 1.0 - cos(3.14159 * along);
    return Relief(vec2(-0.55 * sin(3.14159 * along), -1.5 * across), 0.13 - 0.34 * gap - 0.16 * dip, 0.0);
}

Relief turned(Relief r) {
    return Relief(r.slope.yx, r.shade, r.rough);
}

Relief plainWeave(vec2 at) {
    vec2 cell = floor(at);
    vec2 inside = at - cell - 0.5;
    bool warpOnTop = mod(cell.x + cell.y, 2.0) < 0.5;
    return warpOnTop ? thread(inside.x, inside.y) : turned(thread(inside.y, inside.x));
}

// Three over, one under: dyed warp floats, and pale weft shows between them along the diagonal.
Relief twill(vec2 at) {
    vec2 cell = floor(at);
    vec2 inside = at - cell - 0.5;
    float place = mod(cell.x + cell.y, 4.0);
    if (place < 0.5) {
        Relief weft = turned(thread(inside.y, inside.x));
        weft.shade += 0.54;
        return weft;
    }
    Relief warp = thread((place - 2.0 + inside.x) / 3.0, inside.y);
    warp.shade -= 0.15;
    return warp;
}

// Wales of V-shaped loops along x.
Relief knit(vec2 at) {
    float wale = fract(at.y) - 0.5;
    float side = wale < 0.0 ? -1.0 : 1.0;
    float leg = abs(wale) - 0.25;
    float across = fract(at.x * 1.25 + 1.8 * abs(wale)) - 0.5;
    float groove = smoothstep(0.13, 0.25, abs(leg));
    float gap = smoothstep(0.25, 0.5, abs(across));
    vec2 slope = -1.6 * across * vec2(1.25, 1.8 * side) - vec2(0.0, 2.4 * leg * side);
    return Relief(slope, 0.17 - 0.30 * gap - 0.34 * groove, 0.0);
}

Relief crossing(vec2 at) {
    float weave = threading.y;
    if (weave < 0.5) return plainWeave(at);
    return weave < 1.5 ? twill(at) : knit(at);
}
