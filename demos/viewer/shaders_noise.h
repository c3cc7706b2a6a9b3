// Smooth randomness for the weave and the clouds: a GLSL source piece.
#pragma once

namespace drench::viewer::shaders {

// valueNoise wanders between -0.5 and 0.5 with one bump for each unit square.
inline constexpr char noise[] = R"(
float latticeValue(vec2 cell) {
    vec3 mixed = fract(vec3(cell.xyx) * vec3(0.1031, 0.1030, 0.0973));
    mixed += dot(mixed, mixed.yzx + 33.33);
    return fract((mixed.x + mixed.y) * mixed.z) - 0.5;
}

float valueNoise(vec2 at) {
    vec2 cell = floor(at);
    vec2 inside = at - cell;
    inside = inside * inside * (3.0 - 2.0 * inside);
    float lower = mix(latticeValue(cell), latticeValue(cell + vec2(1.0, 0.0)), inside.x);
    float upper = mix(latticeValue(cell + vec2(0.0, 1.0)), latticeValue(cell + vec2(1.0, 1.0)), inside.x);
    return mix(lower, upper, inside.y);
}
)";

}  // namespace drench::viewer::shaders
