// How sheets are drawn: GLSL source pieces.
#pragma once

namespace drench::viewer::shaders {

inline constexpr char sheetVertex[] = R"(
layout(location = 0) in vec3 nodePosition;
layout(location = 1) in vec3 nodeNormal;
layout(location = 2) in vec3 nodeAlbedo;
layout(location = 3) in float nodeGloss;
layout(location = 4) in float nodeHollow;
layout(location = 5) in vec2 nodeCloth;
out vec3 position;
out vec3 normal;
out vec3 albedo;
out float gloss;
out float hollow;
out vec2 cloth;

void main() {
    position = nodePosition;
    normal = nodeNormal;
    albedo = nodeAlbedo;
    gloss = nodeGloss;
    hollow = nodeHollow;
    cloth = nodeCloth;
    gl_Position = clipFromWorld * vec4(nodePosition, 1.0);
}
)";

// The thread pattern, from uneven slubs of a few centimetres down to single threads; each scale fades out
// before a pixel becomes too wide for it.
inline constexpr char weave[] = R"(
float weavePattern(vec2 at) {
    float pixel = max(length(dFdx(at)), length(dFdy(at)));
    float pattern = 0.0;
    float threads = 90.0;
    for (int i = 0; i < 4; ++i) {
        float kept = 1.0 - smoothstep(0.25, 0.6, pixel * threads);
        if (kept > 0.0) {
            float warp = valueNoise(at * threads * vec2(1.0, 0.07));
            float weft = valueNoise(at * threads * vec2(0.07, 1.0));
            pattern += kept * (warp + weft);
        }
        threads *= 2.6;
    }
    return pattern;
}
)";

inline constexpr char sheetFragment[] = R"(
in vec3 position;
in vec3 normal;
in vec3 albedo;
in float gloss;
in float hollow;
in vec2 cloth;
out vec4 colour;

void main() {
    float side = gl_FrontFacing ? 1.0 : -1.0;
    Surface s;
    s.position = position;
    s.normal = side * normalize(normal);
    float dryness = 1.0 - 0.6 * gloss;
    s.albedo = albedo * (1.0 + 0.10 * dryness * weavePattern(cloth));
    s.reflectance = mix(0.012, 0.02, gloss);
    s.roughness = mix(0.9, 0.27, gloss);
    s.translucency = mix(0.30, 0.34, gloss);
    float fold = clamp(side * hollow * 0.09, -0.3, 1.0);
    s.openness = (1.0 - 0.5 * max(fold, 0.0)) * opennessAmongBalls(position, s.normal) *
                 opennessAboveGround(position, s.normal);
    colour = vec4(toneMapped(shaded(s)), 1.0);
}
)";

}  // namespace drench::viewer::shaders
