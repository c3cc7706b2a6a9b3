// The threads of a cloth: GLSL source pieces.
#pragma once

namespace drench::viewer::shaders {

// A relief in material coordinates, metres: how the surface slopes along warp and weft, how bright it is over the mean,
// and how much of its slope is too fine for the pixel.
inline constexpr char relief[] = R"(
struct Relief {
    vec2 slope;
    float shade;
    float rough;
};

// Smooth randomness between -0.5 and 0.5 in x, its slopes in yz.
vec3 noiseAndSlope(vec2 at) {
    vec2 cell = floor(at);
    vec2 inside = at - cell;
    vec2 eased = inside * inside * (3.0 - 2.0 * inside);
    vec2 easing = 6.0 * inside * (1.0 - inside);
    float a = latticeValue(cell);
    float b = latticeValue(cell + vec2(1.0, 0.0)) - a;
    float c = latticeValue(cell + vec2(0.0, 1.0)) - a;
    float d = latticeValue(cell + vec2(1.0, 1.0)) - a - b - c;
    return vec3(a + b * eased.x + c * eased.y + d * eased.x * eased.y, easing * (vec2(b, c) + d * eased.yx));
}
)";

// One crossing of threads, in threads: slopes, and brightness over the mean.
inline constexpr char threads[] = R"(
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
    if (weave < 0.5) {
        return plainWeave(at);
    }
    return weave < 1.5 ? twill(at) : knit(at);
}
)";

// Slubs and streaks from centimetres down to the single threads. Each scale fades out before it is finer than `pixel`,
// the width in metres of cloth that the pixel sees.
inline constexpr char cloth[] = R"(
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
    if (kept <= 0.0) {
        return vec2(0.0);
    }
    vec3 wide = noiseAndSlope(at * 9.0 + 1.9);
    vec3 narrow = noiseAndSlope(at * 22.0 + 0.35 * wide.yz + 4.1);
    return kept * (0.10 * wide.yz + 0.07 * narrow.yz);
}

Relief clothRelief(vec2 at, float pixel, float dryness) {
    if (threading.x <= 0.0) {
        return Relief(vec2(0.0), 0.0, 0.0);
    }
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
)";

// The border of a rectangular sheet, folded over and sewn down.
inline constexpr char hem[] = R"(
struct Hem {
    // 1 where the cloth lies double.
    float folded;
    // Brightness over the mean.
    float shade;
    vec2 slope;
};

// The share of the pixel that a line covers.
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

// The share of the pixel that stitches cover, one by one close by.
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
    if (width <= 0.0 || inwards > 4.0 * width) {
        return Hem(0.0, 0.0, vec2(0.0));
    }
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
)";

}  // namespace drench::viewer::shaders
