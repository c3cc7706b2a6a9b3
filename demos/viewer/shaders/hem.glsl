// The border of a rectangular sheet, folded over and sewn down.
struct Hem {
    // 1 where the cloth lies double.
    float folded;
    // Brightness over the mean.
    float shade;
    vec2 slope;
};

// The fraction of the pixel that a line covers.
float lineCover(float away, float halfWidth, float pixel) {
    return clamp((halfWidth + 0.5 * pixel - abs(away)) / pixel, 0.0, 1.0) * min(2.0 * halfWidth / pixel, 1.0);
}

// The thread of the seam draws the cloth together into small waves along it.
float ripple(float along, float fromSeam, float width, float pixel) {
    float wave = 1.3 * width;
    float near = fromSeam / width;
    float kept = 1.0 - smoothstep(0.25, 0.6, pixel / wave);
    return 0.16 * exp(-near * near) * kept * noiseAndSlope(vec2(along / wave, 0.5)).y;
}

// The fraction of the pixel that stitches cover; single stitches at close range.
float stitches(float along, float fromSeam, float pixel) {
    const float length = 0.0035;
    float single = smoothstep(0.25, 0.35, abs(fract(along / length) - 0.5));
    float kept = 1.0 - smoothstep(0.3, 0.7, pixel / length);
    return lineCover(fromSeam, 0.0005, pixel) * mix(0.7, single, kept);
}

Hem hemAt(vec2 at, float pixel) {
    float width = threading.z;
    vec2 fromLow = at - clothBounds.xy;
    vec2 fromHigh = clothBounds.zw - at;
    vec2 near = min(fromLow, fromHigh);
    bool alongWarp = near.y < near.x;
    float inwards = min(near.x, near.y);
    if (width <= 0.0 || inwards > 4.0 * width) return Hem(0.0, 0.0, vec2(0.0));
    float along = alongWarp ? at.x : at.y;
    vec2 direction = alongWarp ? vec2(0.0, fromLow.y < fromHigh.y ? 1.0 : -1.0)
                               : vec2(fromLow.x < fromHigh.x ? 1.0 : -1.0, 0.0);
    float fromSeam = inwards - 0.8 * width;
    float ledge = lineCover(inwards - width, 0.0008, pixel);
    float rim = lineCover(inwards, 0.0009, pixel);
    float shade = -0.14 * ledge - 0.22 * stitches(along, fromSeam, pixel) - 0.20 * rim;
    vec2 slope = direction * (0.5 * rim - 0.4 * ledge) + ripple(along, fromSeam, width, pixel) * direction.yx;
    return Hem(clamp((width - inwards) / pixel + 0.5, 0.0, 1.0), shade, slope);
}
