// valueNoise wanders between -0.5 and 0.5 with one bump for each unit square or cube; layeredNoise adds finer
// and finer ones, and leaves out what a pixel `pixel` wide cannot show.
float latticeValue(vec2 cell) {
    vec3 mixed = fract(vec3(cell.xyx) * vec3(0.1031, 0.1030, 0.0973));
    mixed += dot(mixed, mixed.yzx + 33.33);
    return fract((mixed.x + mixed.y) * mixed.z) - 0.5;
}

float latticeValue(vec3 cell) {
    vec3 mixed = fract(cell * vec3(0.1031, 0.1030, 0.0973));
    mixed += dot(mixed, mixed.zyx + 31.32);
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

float valueNoise(vec3 at) {
    vec3 cell = floor(at);
    vec3 inside = at - cell;
    inside = inside * inside * (3.0 - 2.0 * inside);
    const vec2 step = vec2(0.0, 1.0);
    vec4 near = vec4(latticeValue(cell), latticeValue(cell + step.yxx), latticeValue(cell + step.xyx),
                     latticeValue(cell + step.yyx));
    vec4 far = vec4(latticeValue(cell + step.xxy), latticeValue(cell + step.yxy),
                    latticeValue(cell + step.xyy), latticeValue(cell + step.yyy));
    vec4 between = mix(near, far, inside.z);
    vec2 across = mix(between.xz, between.yw, inside.x);
    return mix(across.x, across.y, inside.y);
}

float layeredNoise(vec2 at, float pixel) {
    const mat2 turn = mat2(0.8, 0.6, -0.6, 0.8);
    float sum = 0.0;
    float share = 1.0;
    for (int i = 0; i < 4; ++i) {
        float kept = share * (1.0 - smoothstep(0.3, 0.9, pixel));
        if (kept > 0.0) sum += kept * valueNoise(at);
        at = 2.3 * turn * at + 3.7;
        pixel *= 2.3;
        share *= 0.55;
    }
    return sum;
}

float layeredNoise(vec3 at, float pixel) {
    float sum = 0.0;
    float share = 1.0;
    for (int i = 0; i < 4; ++i) {
        float kept = share * (1.0 - smoothstep(0.3, 0.9, pixel));
        if (kept > 0.0) sum += kept * valueNoise(at);
        at = 2.3 * at.yzx + 3.7;
        pixel *= 2.3;
        share *= 0.55;
    }
    return sum;
}
