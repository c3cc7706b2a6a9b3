// The background seen through a sheet: the scene without sheets, blurred by its distance behind the sheet.
uniform sampler2D scene;
uniform sampler2D sceneDepth;

// Product of the transmittances of all sheets that cover a pixel.
uniform sampler2D sheetLayers;

// Transmittance of the other sheets, for a sheet that is visible itself.
float otherLayers(float transmittance) {
    return min(texelFetch(sheetLayers, ivec2(gl_FragCoord.xy), 0).r / max(transmittance, 0.01), 1.0);
}

// Fraction of the transmitted light that is not scattered: exp(-S h) over the transmittance 1 / (1 + S h).
float clearness(float transmittance) {
    return exp(1.0 - 1.0 / max(transmittance, 0.02)) / max(transmittance, 0.02);
}

// The light from behind, and in w the distance of the background behind the sheet, m.
vec4 lightBehind(float clear) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float away = lens.y / (2.0 * texelFetch(sceneDepth, pixel, 0).r - 1.0 + lens.x);
    float gap = max(away - 1.0 / gl_FragCoord.w, 0.0);
    float spread = 0.05 + 0.5 * (1.0 - clear);
    float radius = clamp(gap * spread / (lens.z * away), 0.0, 64.0);
    vec2 size = vec2(textureSize(scene, 0));
    float level = max(log2(max(radius, 1.0)) - 0.5, 0.0);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        vec2 offset = 0.7 * radius * pattern(i, 4, 0.7);
        sum += textureLod(scene, (gl_FragCoord.xy + offset) / size, level).rgb;
    }
    return vec4(beforeToneMapping(0.25 * sum), gap);
}
