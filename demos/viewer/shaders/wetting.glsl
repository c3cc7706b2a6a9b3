uniform sampler2D wetness;

// A picture without patches has a map with a single dry pixel, to which all lookups are clamped.
float wetnessHere() {
    float water = texture(wetness, gl_FragCoord.xy / vec2(textureSize(wetness, 0))).r;
    return smoothstep(0.0, 0.75, water);
}

// Light that a film of water keeps inside is absorbed more often (Angstrom 1925).
vec3 wetAlbedo(vec3 dry, float wet) {
    const float index2 = 1.33 * 1.33;
    return mix(dry, dry / (index2 * (1.0 - dry) + dry), wet);
}

// A film of water is glossy and fills roughness; a damp spot is dark but not yet glossy.
void makeWet(inout Surface s, float wet) {
    float film = wet * wet * wet;
    s.albedo = wetAlbedo(s.albedo, wet);
    s.reflectance = mix(s.reflectance, 0.02, film);
    s.roughness = mix(s.roughness, min(s.roughness, 0.42), film);
}

// The normal of a surface that rises by `height`, metres, over the smooth one.
vec3 bumped(vec3 position, vec3 normal, float height) {
    vec3 right = dFdx(position);
    vec3 up = dFdy(position);
    vec3 acrossUp = cross(up, normal);
    vec3 acrossRight = cross(normal, right);
    float area = dot(right, acrossUp);
    vec3 rise = sign(area) * (dFdx(height) * acrossUp + dFdy(height) * acrossRight);
    return normalize(abs(area) * normal - rise);
}
