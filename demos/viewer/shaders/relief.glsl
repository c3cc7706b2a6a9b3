// A relief in material coordinates, metres: how the surface slopes along warp and weft, how bright it is over the mean,
// and how much of its slope is too fine for the pixel.
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
