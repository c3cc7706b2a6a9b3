// A terrace of flagstones round the origin, and a lawn from there to the haze.
in vec3 position;
out vec4 colour;

struct Soil {
    vec3 albedo;
    float height;
};

// Small round holes, one in some of the cells of a grid: 1 in them, 0 elsewhere.
float pores(vec2 at, float pixel) {
    const float perMetre = 95.0;
    vec2 scaled = perMetre * at;
    vec2 cell = floor(scaled);
    vec2 middle = vec2(latticeValue(cell), latticeValue(cell + 57.0));
    float radius = 0.16 * latticeValue(cell + 23.0) + 0.02;
    float away = length(scaled - cell - 0.5 - 0.6 * middle);
    float soft = 0.07 + perMetre * pixel;
    return (1.0 - smoothstep(radius - soft, radius + soft, away)) * step(0.0, radius) *
           (1.0 - smoothstep(0.0010, 0.0022, pixel));
}

// Rows of flagstones, 0.5 m by 0.7 m, each with its own tone, with sand in the joints.
Soil paving(vec2 at, float pixel) {
    const vec2 size = vec2(0.7, 0.5);
    const float halfJoint = 0.005;
    float wobble = 0.006 * layeredNoise(9.0 * at, 9.0 * pixel);
    vec2 moved = at + wobble;
    float row = floor(moved.y / size.y);
    vec2 grid = vec2(moved.x / size.x + 7.0 * latticeValue(vec2(row, 11.0)), moved.y / size.y);
    vec2 slab = floor(grid);
    vec2 away = (0.5 - abs(grid - slab - 0.5)) * size;
    float edge = min(away.x, away.y);
    float joint = clamp((halfJoint + 0.5 * pixel - edge) / max(pixel, 1e-5), 0.0, 1.0) *
                  min(2.0 * halfJoint / max(pixel, 1e-5), 1.0);
    float tone = latticeValue(slab);
    float stains = layeredNoise(1.6 * at + 3.0 * tone, 1.6 * pixel);
    float grain = layeredNoise(60.0 * at, 60.0 * pixel);
    float pits = layeredNoise(21.0 * at + 17.0 * tone, 21.0 * pixel);
    const vec3 grey = vec3(0.265, 0.262, 0.248), warm = vec3(0.285, 0.258, 0.212);
    vec3 stoneAlbedo = mix(grey, warm, 0.5 + 0.9 * latticeValue(slab + 31.0));
    stoneAlbedo *= 1.0 + 0.16 * tone + 0.16 * stains + 0.20 * grain + 0.12 * pits - 0.22 * pores(at, pixel);
    vec3 sand = vec3(0.115, 0.105, 0.078) * (1.0 + 0.3 * grain);
    float rounded = smoothstep(0.0, 0.02, edge) * (1.0 - smoothstep(0.004, 0.02, pixel));
    // The pits of a slab do not continue in the next slab.
    float uneven = (1.0 - joint) * (0.0007 * grain + 0.0010 * pits);
    return Soil(mix(stoneAlbedo, sand, joint), 0.0016 * rounded + uneven);
}

// Short grass, seen as tufts and patches.
Soil lawn(vec2 at, float pixel) {
    float patches = layeredNoise(0.35 * at, 0.35 * pixel);
    float tufts = layeredNoise(11.0 * at, 11.0 * pixel);
    float blades = layeredNoise(90.0 * at, 90.0 * pixel);
    const vec3 dark = vec3(0.080, 0.115, 0.034), pale = vec3(0.150, 0.165, 0.060);
    vec3 grass = mix(dark, pale, 0.5 + 0.5 * patches + 0.25 * tufts);
    return Soil(grass * (1.0 + 0.35 * tufts + 0.45 * blades), 0.004 * tufts + 0.002 * blades);
}

// 1 on the terrace, 0 on the lawn.
float onTerrace(vec2 at, float pixel) {
    vec2 outside = abs(at) - vec2(5.6, 4.5);
    float edge = max(outside.x, outside.y) + 0.05 * layeredNoise(4.0 * at, 4.0 * pixel);
    return 1.0 - smoothstep(-0.02 - pixel, 0.02 + pixel, edge);
}

// Wetness of open ground by rain: spots that merge, then a film.
float openWetness(vec2 at, float pixel) {
    if (ground.z <= 0.0) return 0.0;
    vec2 outside = max(patched.xy - at, at - patched.zw);
    float away = max(outside.x, outside.y) + 0.7 * layeredNoise(1.7 * at, 1.7 * pixel);
    float open = smoothstep(-0.5, 0.0, away);
    float soft = mix(0.2, 1.0, smoothstep(0.3, 0.9, 14.0 * pixel));
    float spots = 1.2 * layeredNoise(14.0 * at, 14.0 * pixel);
    return ground.w * open * smoothstep(-soft, soft, spots + 2.4 * ground.z - 1.2);
}

void main() {
    const vec3 up = vec3(0.0, 1.0, 0.0);
    vec2 at = position.xz;
    float pixel = max(length(dFdx(at)), length(dFdy(at)));
    Soil soil = lawn(at, pixel);
    float paved = onTerrace(at, pixel);
    if (paved > 0.0) {
        Soil slabs = paving(at, pixel);
        soil = Soil(mix(soil.albedo, slabs.albedo, paved), mix(soil.height, slabs.height, paved));
    }
    Surface s;
    s.position = position;
    s.albedo = soil.albedo;
    s.reflectance = 0.0;
    s.roughness = 1.0;
    s.openness = opennessAmongBalls(position, up);
    float wet = max(wetnessHere(), openWetness(at, pixel)) * mix(0.35, 1.0, paved);
    // A film of water lies smoothly over what is uneven.
    s.normal = normalize(mix(bumped(position, up, soil.height), up, 0.8 * wet));
    makeWet(s, wet);
    vec3 away = position - eye.xyz;
    float haze = 1.0 - exp(-pow(length(away) / 75.0, 1.5));
    vec3 level = normalize(vec3(away.x, 0.0, away.z) + vec3(1e-6));
    colour = vec4(toneMapped(mix(shaded(s), skyLight(level), haze)), 1.0);
}
