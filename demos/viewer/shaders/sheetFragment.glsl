in vec3 position;
in vec3 normal;
in vec3 albedo;
in float gloss;
in float dampness;
in float transmittance;
in float hollow;
in float value;
in vec2 cloth;
out vec4 colour;

// The normal of a surface that slopes by `slope` along the material coordinates.
vec3 sloped(vec3 upright, vec2 slope, vec3 rightwards, vec3 upwards, vec2 clothRight, vec2 clothUp) {
    vec3 first = cross(upwards, upright);
    vec3 second = cross(upright, rightwards);
    float area = dot(rightwards, first);
    vec3 gradient = sign(area) * (first * dot(slope, clothRight) + second * dot(slope, clothUp));
    return normalize(max(abs(area), 1e-12) * upright - gradient);
}

// An even colour map, with enough light and shade that the shape is seen.
vec3 valueColour(vec3 upright) {
    float share = clamp((value - legend.x) / (legend.y - legend.x), 0.0, 1.0) * 8.0;
    int lower = min(int(share), 7);
    vec3 mapped = mix(legendColours[lower].rgb, legendColours[lower + 1].rgb, share - float(lower));
    float wrapped = 0.5 + 0.5 * dot(upright, normalize(towardsSun.xyz + normalize(eye.xyz - position)));
    return mapped * mix(0.25, 1.0, wrapped);
}

void main() {
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec3 upright = side * normalize(normal);
    if (legend.z > 0.5) {
        colour = vec4(valueColour(upright), 1.0);
        return;
    }
    vec3 rightwards = dFdx(position), upwards = dFdy(position);
    vec2 clothRight = dFdx(cloth), clothUp = dFdy(cloth);
    float pixel = max(max(length(clothRight), length(clothUp)), 1e-7);
    float dryness = 1.0 - smoothstep(0.05, 0.6, dampness);
    Relief relief = clothRelief(cloth, pixel, mix(0.35, 1.0, dryness));
    Hem sewn = hemAt(cloth, pixel);
    vec2 slope = side * (relief.slope + sewn.slope);

    Cloth c;
    c.position = position;
    c.normal = sloped(upright, slope, rightwards, upwards, clothRight, clothUp);
    // A thick film levels the threads under it, but never quite: smooth is only foil.
    float levelled = mix(0.9, 0.5, gloss);
    c.filmNormal = sloped(upright, levelled * slope, rightwards, upwards, clothRight, clothUp);
    float pale = threading.y > 0.5 && threading.y < 1.5 ? 1.0 : mix(0.75, 1.0, dryness);
    c.albedo = clamp(albedo * (1.0 + pale * relief.shade) * (1.0 + sewn.shade), 0.0, 0.97);
    c.transmittance = mix(transmittance, transmittance / (2.0 - transmittance), sewn.folded);
    // While little water stands on the cloth it lies in patches, between the highest threads.
    float patches = smoothstep(0.0, 0.5, 1.4 * gloss - 0.2 + 3.0 * relief.shade);
    float menisci = 0.6 * smoothstep(0.1, 0.6, dampness);
    c.film = max(patches * smoothstep(0.0, 0.15, gloss), menisci);
    c.roughness = mix(mix(0.50, 0.36, menisci), 0.28, gloss) + levelled * levelled * relief.rough;
    c.dryness = dryness;
    float fold = clamp(side * hollow * 0.09, -0.3, 1.0);
    // However close a ball is, some light comes along between it and the cloth.
    c.openness = (1.0 - 0.4 * max(fold, 0.0)) * max(opennessAmongBalls(position, upright), 0.4) *
                 opennessAboveGround(position, upright);
    colour = vec4(toneMapped(clothLight(c)), 1.0);
}
