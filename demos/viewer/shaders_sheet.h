// How sheets are drawn: GLSL source pieces.
#pragma once

namespace drench::viewer::shaders {

// The uniform block of sheet_uniforms.h.
inline constexpr char sheetBlock[] = R"(
layout(std140) uniform Sheet {
    vec4 clothBounds;
    vec4 threading;
    vec4 legend;
    vec4 legendColours[9];
};
)";

inline constexpr char sheetVertex[] = R"(
layout(location = 0) in vec3 nodePosition;
layout(location = 1) in vec3 nodeNormal;
layout(location = 2) in vec3 nodeAlbedo;
layout(location = 3) in vec3 nodeWater;
layout(location = 4) in vec2 nodeShape;
layout(location = 5) in vec2 nodeCloth;
out vec3 position;
out vec3 normal;
out vec3 albedo;
out float gloss;
out float dampness;
out float transmittance;
out float hollow;
out float value;
out vec2 cloth;

void main() {
    position = nodePosition;
    normal = nodeNormal;
    albedo = nodeAlbedo;
    gloss = nodeWater.x;
    dampness = nodeWater.y;
    transmittance = nodeWater.z;
    hollow = nodeShape.x;
    value = nodeShape.y;
    cloth = nodeCloth;
    gl_Position = clipFromWorld * vec4(nodePosition, 1.0);
}
)";

// What passes dyed cloth.
inline constexpr char dye[] = R"(
// The layer of Kubelka and Munk with the absorption that its albedo tells, of a transmittance that is without any.
// Light that is scattered, or thrown back into the cloth where it would leave it into air, takes `detour` times the way.
vec3 passingDye(vec3 albedo, float transmittance, float detour) {
    float scattering = detour * (1.0 / max(transmittance, 1e-3) - 1.0);
    vec3 a = 1.0 + (1.0 - albedo) * (1.0 - albedo) / (2.0 * max(albedo, 1e-3));
    vec3 b = sqrt(a * a - 1.0) + 1e-4;
    vec3 grown = exp(min(b * scattering, 40.0));
    return 2.0 * b / ((a + b) * grown + (b - a) / grown);
}
)";

// What is seen through a sheet: the scene without sheets, blurred by the way behind the sheet.
inline constexpr char seeThrough[] = R"(
uniform sampler2D scene;
uniform sampler2D sceneDepth;

// What all sheets that cover a pixel let through, one after the other.
uniform sampler2D sheetLayers;

// What the others let through to one that is seen itself.
float otherLayers(float transmittance) {
    return min(texelFetch(sheetLayers, ivec2(gl_FragCoord.xy), 0).r / max(transmittance, 0.01), 1.0);
}

// Share of the light let through that keeps its way: exp(-S h) over the transmittance 1 / (1 + S h).
float clearness(float transmittance) {
    return exp(1.0 - 1.0 / max(transmittance, 0.02)) / max(transmittance, 0.02);
}

// The light from what lies behind, and in w how far behind it lies, metres.
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
)";

// Light on cloth: diffuse from its front, through it from behind, fibres that catch light at its rim while it is dry,
// and the mirror of a film where water stands on it.
inline constexpr char sheetLight[] = R"(
// Fuzz after Estevez and Kulla (2017), with the visibility of Neubelt and Pettineo (2013), times pi.
float fuzz(vec3 normal, vec3 towardsEye, float facingSun, float facingEye) {
    const float inverseWidth = 1.0 / 0.45;
    float facingHalf = dot(normal, normalize(towardsEye + towardsSun.xyz));
    float sine = sqrt(max(1.0 - facingHalf * facingHalf, 0.0));
    float density = 0.5 * (2.0 + inverseWidth) * pow(sine, inverseWidth);
    return density / (4.0 * (facingSun + facingEye - facingSun * facingEye) + 1e-3);
}

struct Cloth {
    vec3 position;
    // With threads and creases, and of the film over them.
    vec3 normal;
    vec3 filmNormal;
    vec3 albedo;
    float transmittance;
    // Share that a film covers, and its roughness.
    float film;
    float roughness;
    // 1 where fibres stand off, 0 where water lays them.
    float dryness;
    float openness;
};

vec3 diffuseLight(Cloth c, vec3 sun, float towards) {
    vec3 front = sun * max(towards, 0.0) + ambientLight(c.normal) * c.openness;
    vec3 back = sun * max(-towards, 0.0) + ambientLight(-c.normal) * c.openness;
    float clear = clearness(c.transmittance);
    vec4 behind = lightBehind(clear);
    // What touches the cloth is seen however much light scatters on the way. Cloth that lies on a solid is drawn up to a
    // centimetre off it.
    float touching = 1.0 - smoothstep(0.012, 0.03, behind.w);
    // The sky that the cloth keeps off is still on it.
    behind.rgb *= 1.0 - 0.25 * touching;
    // Between dry threads there are gaps, which water closes to light as it does to air.
    vec3 tint = c.albedo / max(max(c.albedo.r, c.albedo.g), max(c.albedo.b, 1e-3));
    vec3 gaps = 0.35 * c.dryness * c.dryness * c.transmittance * tint;
    vec3 passing = min(passingDye(c.albedo, c.transmittance, mix(2.0, 1.1, touching)) + gaps, 1.0 - c.albedo);
    // Another layer of cloth hides what is behind it, and shows itself.
    vec3 beyond = mix(c.albedo * back, behind.rgb, otherLayers(c.transmittance));
    return c.albedo * front + passing * mix(back, beyond, mix(clear, 1.0, touching));
}

vec3 clothLight(Cloth c) {
    vec3 towardsEye = normalize(eye.xyz - c.position);
    float facingEye = max(dot(c.normal, towardsEye), 0.02);
    float towards = dot(c.normal, towardsSun.xyz);
    float facingSun = max(towards, 0.0);
    vec3 sun = sunLight() * sunVisible(c.position, c.filmNormal);
    vec3 colour = diffuseLight(c, sun, towards);

    float rim = pow(max(1.0 - facingEye, 0.0), 3.0);
    float fibres = 0.10 * c.dryness;
    vec3 haze = fibres * sqrt(c.albedo);
    colour *= 1.0 - fibres * rim;
    colour += haze * (sun * facingSun * fuzz(c.normal, towardsEye, facingSun, facingEye) +
                      rim * c.openness * ambientLight(c.normal));

    Surface film;
    film.normal = c.filmNormal;
    film.reflectance = 0.02;
    film.roughness = c.roughness;
    float filmFacingEye = max(dot(c.filmNormal, towardsEye), 0.02);
    float filmFacingSun = max(dot(c.filmNormal, towardsSun.xyz), 0.0);
    float mirror = 0.02 + (fresnel(0.02, filmFacingEye) - 0.02) * (1.0 - c.roughness);
    colour *= 1.0 - c.film * mirror;
    colour += c.film * mirror * c.openness * mirroredLight(reflect(-towardsEye, c.filmNormal), c.roughness);
    colour += c.film * sun * filmFacingSun * sunGlint(film, towardsEye, filmFacingSun, filmFacingEye);
    return colour;
}
)";

// One layer of cloth, where no solid hides it.
inline constexpr char sheetLayerFragment[] = R"(
in float transmittance;
uniform sampler2D sceneDepth;
out vec4 passing;

void main() {
    if (gl_FragCoord.z > texelFetch(sceneDepth, ivec2(gl_FragCoord.xy), 0).r) {
        discard;
    }
    passing = vec4(transmittance);
}
)";

inline constexpr char sheetFragment[] = R"(
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
)";

}  // namespace drench::viewer::shaders
