// The materials of picture.h, by their numbers. A position `at` is in metres in the frame of the solid, x
// along the grain, y across it, z through the thickness.
const int paint = 0, wood = 1, metal = 2, stone = 3, rope = 4;

struct Finish {
    vec3 albedo;
    float reflectance;
    float roughness;
    // Height above the smooth surface, m.
    float height;
};

Finish woodFinish(vec3 at, vec3 albedo, float pixel) {
    const float ringWidth = 0.008;
    float bent = 0.008 * valueNoise(at * vec3(1.7, 14.0, 14.0));
    bent += 0.02 * valueNoise(at * vec3(0.9, 3.0, 3.0) + 5.0);
    float fromPith = (length(at.yz - vec2(0.043, 0.031)) + bent) / ringWidth;
    // Annual rings differ.
    float rings = fromPith + 1.3 * valueNoise(vec2(0.55 * fromPith, 1.0));
    float strength = 0.65 + 0.7 * valueNoise(vec2(0.9 * fromPith, 8.0));
    float inRing = fract(rings);
    float late = strength * smoothstep(0.1, 0.8, inRing) * (1.0 - smoothstep(0.86, 1.0, inRing));
    late = mix(0.30, late, 1.0 - smoothstep(0.3, 0.9, pixel / ringWidth));
    float streaks = valueNoise(at * vec3(2.5, 55.0, 55.0));
    float fibres = layeredNoise(at * vec3(9.0, 420.0, 420.0), 420.0 * pixel);
    vec3 tone = mix(albedo * 1.15, albedo * vec3(0.62, 0.54, 0.46), late);
    float weathered = valueNoise(at * vec3(1.3, 19.0, 19.0) + 9.0);
    tone *= 1.0 + 0.75 * streaks + 0.55 * weathered + 0.35 * fibres;
    return Finish(tone, 0.04, 0.55 + 0.15 * late, 1.5e-4 * (fibres - 0.4 * late));
}

Finish stoneFinish(vec3 at, vec3 albedo, float pixel) {
    float mottled = layeredNoise(6.0 * at, 6.0 * pixel);
    float grains = layeredNoise(170.0 * at, 170.0 * pixel);
    float height = 6e-4 * grains + 1e-3 * mottled;
    return Finish(albedo * (1.0 + 0.20 * mottled + 0.32 * grains), 0.03, 0.85, height);
}

Finish metalFinish(vec3 at, vec3 albedo, float pixel) {
    float brushed = layeredNoise(at * vec3(8.0, 500.0, 500.0), 500.0 * pixel);
    float dull = layeredNoise(11.0 * at, 11.0 * pixel);
    vec3 tint = mix(albedo, vec3(1.0), 0.12) * (1.0 + 0.08 * brushed);
    return Finish(tint, 0.6, 0.30 + 0.10 * dull, 3e-5 * brushed);
}

Finish paintFinish(vec3 at, vec3 albedo, float pixel) {
    float uneven = layeredNoise(28.0 * at, 28.0 * pixel);
    float grain = layeredNoise(480.0 * at, 480.0 * pixel);
    return Finish(albedo * (1.0 + 0.06 * uneven), 0.04, 0.36 + 0.08 * uneven, 5e-5 * grain);
}

// Three strands, each a helix that goes round once in six radii.
Finish ropeFinish(vec3 at, vec3 albedo, float pixel, float radius) {
    float turn = atan(at.z, at.y) + at.x / radius;
    float strand = abs(sin(1.5 * turn));
    strand = mix(0.64, strand, 1.0 - smoothstep(0.4, 1.2, pixel / radius));
    float fibres = layeredNoise(at * 900.0, 900.0 * pixel);
    return Finish(albedo * (0.45 + 0.75 * strand) * (1.0 + 0.3 * fibres), 0.02, 0.9, 0.25 * radius * strand);
}

Finish finishOf(int material, vec3 at, vec3 albedo, float radius) {
    float pixel = max(length(dFdx(at)), length(dFdy(at)));
    if (material == wood) return woodFinish(at, albedo, pixel);
    if (material == metal) return metalFinish(at, albedo, pixel);
    if (material == stone) return stoneFinish(at, albedo, pixel);
    if (material == rope) return ropeFinish(at, albedo, pixel, radius);
    return paintFinish(at, albedo, pixel);
}

// Bare metal mirrors in its own colour and scatters next to nothing.
vec3 shadedMetal(Surface s) {
    vec3 towardsEye = normalize(eye.xyz - s.position);
    float facingEye = max(dot(s.normal, towardsEye), 0.02);
    float facingSun = max(dot(s.normal, towardsSun.xyz), 0.0);
    vec3 sun = sunLight() * sunVisible(s.position, s.normal) * facingSun;
    vec3 mirrored = mirroredLight(reflect(-towardsEye, s.normal), s.roughness);
    vec3 scattered = 0.25 * (ambientLight(s.normal) + sun);
    vec3 glint = sun * sunGlint(s, towardsEye, facingSun, facingEye);
    return s.albedo * ((0.75 * mirrored + scattered) * s.openness + glint);
}

vec3 shadedSolid(int material, Finish finish, vec3 position, vec3 normal, float openness) {
    Surface s;
    s.position = position;
    s.normal = bumped(position, normal, finish.height);
    s.albedo = finish.albedo;
    s.reflectance = finish.reflectance;
    s.roughness = finish.roughness;
    s.openness = openness;
    float wet = wetnessHere();
    if (material == metal) {
        s.roughness = mix(s.roughness, 0.15, wet);
        return shadedMetal(s);
    }
    // A film of water lies smoothly over what is uneven.
    s.normal = normalize(mix(s.normal, normal, 0.7 * wet));
    // Paint takes up no water.
    vec3 dry = s.albedo;
    makeWet(s, wet);
    s.albedo = material == paint ? mix(dry, s.albedo, 0.3) : s.albedo;
    return shaded(s);
}
