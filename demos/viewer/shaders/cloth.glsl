// Slubs and streaks from centimetres down to the single threads. Each scale fades out before it is finer than `pixel`,
// the width in metres of cloth that the pixel sees.
// Uneven spinning and beating: long along the threads of one direction and a thread or several wide.
Relief streaks(vec2 at, float pixel) {
    Relief sum = Relief(vec2(0.0), 0.0, 0.0);
    float scale = 45.0;
    // Close by, the finer ones stand out most.
    float weight = 1.0;
    float weights = 0.8;
    for (int i = 0; i < 4; ++i) {
        float kept = 1.0 - smoothstep(0.25, 0.6, pixel * scale);
        if (kept > 0.0) {
            const vec2 drawnOut = vec2(1.0, 0.10);
            vec3 weft = noiseAndSlope(at * scale * drawnOut + 3.7);
            vec3 warp = noiseAndSlope(at.yx * scale * drawnOut + 11.3);
            kept *= weight;
            weights += kept;
            sum.shade += kept * (weft.x + warp.x);
            sum.slope += kept * (weft.yz * drawnOut + (warp.yz * drawnOut).yx);
        }
        scale *= 3.1;
        weight *= 1.6;
    }
    return Relief(sum.slope / weights, sum.shade / weights, 0.0);
}

// Small creases that the mesh is too coarse for.
vec2 creases(vec2 at, float pixel) {
    float kept = 1.0 - smoothstep(0.15, 0.5, pixel * 22.0);
    if (kept <= 0.0) return vec2(0.0);
    vec3 wide = noiseAndSlope(at * 9.0 + 1.9);
    vec3 narrow = noiseAndSlope(at * 22.0 + 0.35 * wide.yz + 4.1);
    return kept * (0.10 * wide.yz + 0.07 * narrow.yz);
}

Relief clothRelief(vec2 at, float pixel, float dryness) {
    if (threading.x <= 0.0) return Relief(vec2(0.0), 0.0, 0.0);
    Relief uneven = streaks(at, pixel);
    Relief all = Relief(0.10 * uneven.slope + dryness * creases(at, pixel), 0.15 * uneven.shade, 0.12);
    // The legs of a loop are finer than what one wale is from the next.
    float finest = threading.y > 1.5 ? 0.5 * threading.x : threading.x;
    float kept = 1.0 - smoothstep(0.22, 0.5, pixel / finest);
    if (kept > 0.0) {
        Relief one = crossing(at / threading.x);
        all.slope += kept * one.slope;
        all.shade += kept * one.shade;
    }
    all.rough *= 1.0 - kept;
    return all;
}
