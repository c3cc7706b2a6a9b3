// The light of the scene, shared by every material: GLSL source pieces.
#pragma once

namespace drench::viewer::shaders {

// The uniform block of frame_uniforms.h.
inline constexpr char frame[] = R"(
layout(std140) uniform Frame {
    mat4 clipFromWorld;
    mat4 offsetFromClip;
    mat4 shadowFromWorld;
    vec4 eye;
    vec4 towardsSun;
    vec4 shadowSize;
    vec4 ground;
    vec4 balls[8];
    vec4 lens;
    vec4 patched;
};
)";

// An overcast bright day: a weak, soft sun and a strong sky. Irradiances are divided by pi.
inline constexpr char sky[] = R"(
const vec3 horizonLight = vec3(0.86, 0.885, 0.90);
const vec3 zenithLight = vec3(0.43, 0.55, 0.70);
const vec3 groundAlbedo = vec3(0.235, 0.236, 0.200);

// What passes the clouds.
vec3 sunLight() {
    return towardsSun.w * vec3(0.86, 0.80, 0.71);
}

vec3 skyLight(vec3 direction) {
    // Clouds scatter downwards part of the light that they keep from the sun, grey all over.
    const vec3 cloud = vec3(0.66, 0.70, 0.74);
    vec3 zenith = mix(cloud, zenithLight, towardsSun.w);
    vec3 horizon = mix(0.9, 1.0, towardsSun.w) * horizonLight;
    vec3 light = mix(horizon, zenith, pow(max(direction.y, 0.0), 0.55));
    float aside = 1.0 - max(dot(direction, towardsSun.xyz), 0.0);
    return light + 0.30 * sunLight() * exp(-9.0 * aside);
}

// What a surface mirrors: the sky above, the lit ground below, blended the more the rougher it is.
vec3 mirroredLight(vec3 direction, float roughness) {
    float blur = 0.04 + 0.9 * roughness * roughness;
    vec3 below = groundAlbedo * 0.9;
    // The haze round the sun is far brighter than the screen can show, and a mirror tells.
    float aside = 1.0 - max(dot(direction, towardsSun.xyz), 0.0);
    vec3 glow = 1.8 * sunLight() * exp(-5.0 * aside);
    return mix(below, glow + 1.3 * skyLight(normalize(direction + vec3(0.0, 0.4 * roughness, 0.0))),
               smoothstep(-blur, blur, direction.y));
}

// Light from the whole upper or lower half space onto a surface that faces `normal`.
vec3 ambientLight(vec3 normal) {
    const vec3 above = vec3(0.50, 0.55, 0.60);
    const vec3 below = vec3(0.215, 0.20, 0.175);
    return mix(1.25, 1.0, towardsSun.w) * mix(below, above, 0.5 + 0.5 * normal.y);
}

// Straight up to the knee, then bending towards 1: more light never gives a darker pixel.
vec3 toneMapped(vec3 light) {
    const float knee = 0.5;
    vec3 exposed = 1.14 * light;
    vec3 excess = max(exposed - knee, 0.0) / (1.0 - knee);
    return min(exposed, knee) + (1.0 - knee) * (1.0 - exp(-excess));
}

// The light that toneMapped made such a pixel of.
vec3 beforeToneMapping(vec3 shown) {
    const float knee = 0.5;
    vec3 excess = -log(1.0 - clamp((shown - knee) / (1.0 - knee), 0.0, 0.995));
    return (min(shown, knee) + (1.0 - knee) * excess) / 1.14;
}
)";

// How much of the sun (sunVisible) and of the sky (openness) reaches a point.
inline constexpr char occlusion[] = R"(
uniform sampler2DShadow sunShadow;
// The same map without the comparison.
uniform sampler2D sunDepth;
// Share of the sun that sheets let through, and the depth of the nearest solid.
uniform sampler2D sunPassing;

// A dither angle for each pixel that turns the sampling pattern, so that bands become fine grain.
float pixelAngle() {
    return 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
}

vec2 pattern(int tap, int taps, float start) {
    const float goldenAngle = 2.3999632;
    float angle = start + goldenAngle * float(tap);
    return sqrt((float(tap) + 0.5) / float(taps)) * vec2(cos(angle), sin(angle));
}

// Radius over which shadow edges are smeared, metres: the farther from what casts the shadow, the more. 0 where
// nothing near `map` casts one.
float penumbra(vec3 map, float start) {
    const int taps = 10;
    const float search = 0.11;
    // The half angle under which the hazy sun appears, a good deal wider than the bare one.
    const float sunHalfAngle = 0.045;
    float blockers = 0.0;
    float depths = 0.0;
    for (int i = 0; i < taps; ++i) {
        // Closer together in the middle, so that what is thin is not missed.
        float reach = search * sqrt((float(i) + 0.5) / float(taps));
        float depth = texture(sunDepth, map.xy + reach / shadowSize.x * pattern(i, taps, start)).r;
        float blocks = step(depth, min(map.z, 0.99999));
        blockers += blocks;
        depths += blocks * depth;
    }
    if (blockers == 0.0) {
        return 0.0;
    }
    float gap = (map.z - depths / blockers) * shadowSize.z;
    return clamp(sunHalfAngle * gap, max(0.008, 1.5 * shadowSize.y), search);
}

float sunVisible(vec3 position, vec3 normal) {
    const int taps = 20;
    // Moves the point off its own surface, to the side that the sun is on.
    float facing = dot(normal, towardsSun.xyz);
    vec3 outwards = facing < 0.0 ? -normal : normal;
    float slope = sqrt(max(1.0 - facing * facing, 0.0));
    vec3 lifted = position + outwards * (0.003 + 0.012 * slope + 1.5 * shadowSize.y);
    vec3 map = (shadowFromWorld * vec4(lifted, 1.0)).xyz * 0.5 + 0.5;
    if (any(lessThan(map.xy, vec2(0.0))) || any(greaterThan(map.xy, vec2(1.0)))) {
        return 1.0;
    }
    float start = pixelAngle();
    float radius = penumbra(map, start) / shadowSize.x;
    if (radius == 0.0) {
        return 1.0;
    }
    // Ground beyond the far plane of the map is still behind everything that casts a shadow.
    float depth = min(map.z, 0.99999);
    float visible = 0.0;
    vec2 throughSheets = vec2(0.0, 1e-4);
    for (int i = 0; i < taps; ++i) {
        vec2 at = map.xy + radius * pattern(i, taps, start);
        float lit = texture(sunShadow, vec3(at, depth));
        visible += lit;
        if (i % 2 == 0) {
            vec2 passing = texture(sunPassing, at).xy;
            // Where there is no sheet at all, a solid is in the way.
            passing.x *= step(passing.x, 0.999) * step(depth, passing.y + 0.0005);
            throughSheets += (1.0 - lit) * vec2(passing.x, 1.0);
        }
    }
    visible /= float(taps);
    return visible + (1.0 - visible) * throughSheets.x / throughSheets.y;
}

// The share of the sky that the balls leave open, seen from a surface facing `normal`.
float opennessAmongBalls(vec3 position, vec3 normal) {
    float open = 1.0;
    for (int i = 0; i < int(ground.y); ++i) {
        vec3 towards = balls[i].xyz - position;
        float distance2 = dot(towards, towards);
        float radius2 = balls[i].w * balls[i].w;
        // Close to a ball the formula for a far one would cover more than all of the sky.
        float covered = radius2 / max(distance2, radius2);
        float facing = clamp(0.5 + 0.5 * dot(normal, towards) * inversesqrt(max(distance2, 1e-8)), 0.0, 1.0);
        open *= 1.0 - 0.9 * covered * facing * facing;
    }
    return open;
}

float opennessAboveGround(vec3 position, vec3 normal) {
    float height = max(position.y - ground.x, 0.0);
    return 1.0 - 0.35 * exp(-height / 0.15) * (0.5 - 0.5 * normal.y);
}
)";

// What no light passes through, under a smooth coat (F0, roughness), lit by the sun and the sky.
inline constexpr char material[] = R"(
struct Surface {
    vec3 position;
    vec3 normal;
    vec3 albedo;
    float reflectance;
    float roughness;
    float openness;
};

float fresnel(float reflectance, float cosine) {
    float away = 1.0 - cosine;
    float square = away * away;
    return reflectance + (1.0 - reflectance) * square * square * away;
}

// The GGX lobe with Smith's shadowing term, times pi because sunLight is divided by it.
float sunGlint(Surface s, vec3 towardsEye, float facingSun, float facingEye) {
    vec3 halfway = normalize(towardsEye + towardsSun.xyz);
    float a2 = pow(s.roughness, 4.0);
    float facingHalf = max(dot(s.normal, halfway), 0.0);
    float spread = facingHalf * facingHalf * (a2 - 1.0) + 1.0;
    float visibility = 0.5 / (facingSun * sqrt(a2 + (1.0 - a2) * facingEye * facingEye) +
                              facingEye * sqrt(a2 + (1.0 - a2) * facingSun * facingSun) + 1e-4);
    return fresnel(s.reflectance, max(dot(towardsEye, halfway), 0.0)) * a2 / (spread * spread) * visibility;
}

vec3 shaded(Surface s) {
    vec3 towardsEye = normalize(eye.xyz - s.position);
    float facingEye = max(dot(s.normal, towardsEye), 0.02);
    float facingSun = max(dot(s.normal, towardsSun.xyz), 0.0);
    vec3 sun = sunLight() * sunVisible(s.position, s.normal);

    vec3 front = sun * facingSun + ambientLight(s.normal) * s.openness;
    vec3 colour = s.albedo * front;

    // Rough surfaces lose most of the grazing shine.
    float smoothness = 1.0 - s.roughness;
    float shine = s.reflectance + (fresnel(s.reflectance, facingEye) - s.reflectance) * smoothness;
    colour += shine * s.openness * mirroredLight(reflect(-towardsEye, s.normal), s.roughness);
    colour += sun * facingSun * sunGlint(s, towardsEye, facingSun, facingEye);
    return colour;
}
)";

}  // namespace drench::viewer::shaders
