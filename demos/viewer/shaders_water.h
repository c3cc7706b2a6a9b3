// How standing water is drawn: GLSL source pieces.
#pragma once

namespace drench::viewer::shaders {

inline constexpr char waterVertex[] = R"(
layout(location = 0) in vec4 cornerAndAxis;
layout(location = 1) in vec4 centreAndTime;
layout(location = 4) in vec4 halfExtents;
out vec3 position;
flat out vec3 normal;
flat out vec3 centre;
flat out vec3 extents;
flat out float time;
flat out mat4 worldFromScreen;

void main() {
    vec3 corner = cornerAndAxis.xyz;
    normal = corner * vec3(equal(ivec3(0, 1, 2), ivec3(int(cornerAndAxis.w + 0.5))));
    centre = centreAndTime.xyz;
    extents = halfExtents.xyz;
    time = centreAndTime.w;
    position = centre + extents * corner;
    worldFromScreen = inverse(clipFromWorld);
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
)";

// Looks up what the finished picture shows where the bent ray ends, and dims it by its way through the water.
inline constexpr char waterFragment[] = R"(
in vec3 position;
flat in vec3 normal;
flat in vec3 centre;
flat in vec3 extents;
flat in float time;
flat in mat4 worldFromScreen;
out vec4 colour;

uniform sampler2D scene;
uniform sampler2D sceneDepth;

// More than clear water takes, so that a tank of half a metre shows it; 1/m.
const vec3 absorption = vec3(0.95, 0.34, 0.26);
const vec3 scattered = vec3(0.09, 0.19, 0.22);

float height(vec2 at) {
    return valueNoise(7.0 * at + vec2(0.9, 0.4) * time) + 0.55 * valueNoise(15.0 * at.yx - vec2(0.5, 1.3) * time) +
           0.22 * valueNoise(34.0 * at + vec2(-1.7, 1.1) * time);
}

vec3 rippled() {
    const float slope = 0.0055, step = 0.004;
    vec2 at = position.xz;
    float here = height(at);
    vec2 rise = vec2(height(at + vec2(step, 0.0)) - here, height(at + vec2(0.0, step)) - here) / step;
    return normalize(vec3(-slope * rise.x, 1.0, -slope * rise.y));
}

vec3 behind(ivec2 pixel) {
    vec2 size = vec2(textureSize(sceneDepth, 0));
    vec3 screen = vec3((vec2(pixel) + 0.5) / size, texelFetch(sceneDepth, pixel, 0).r) * 2.0 - 1.0;
    vec4 point = worldFromScreen * vec4(screen, 1.0);
    return point.xyz / point.w;
}

// How far a ray from here goes until it leaves the water.
float wayThrough(vec3 direction) {
    vec3 steady = mix(vec3(1e-5), direction, greaterThan(abs(direction), vec3(1e-5)));
    vec3 ways = (sign(steady) * extents - (position - centre)) / steady;
    return max(min(ways.x, min(ways.y, ways.z)), 0.0);
}

ivec2 pixelOf(vec3 place) {
    vec4 clip = clipFromWorld * vec4(place, 1.0);
    vec2 size = vec2(textureSize(scene, 0));
    return ivec2(clamp((clip.xy / clip.w * 0.5 + 0.5) * size, vec2(0.0), size - 1.0));
}

bool inWater(vec3 place) {
    return all(lessThan(abs(place - centre), extents + 0.01));
}

// Where a ray into the water meets something that the camera sees, as a share of its way; 1 if nowhere.
float firstMet(vec3 way) {
    const int steps = 24;
    // What the ray passes behind is not met.
    float thickness = 2.0 * length(way) / float(steps);
    float from = 0.0;
    float to = 1.0;
    bool met = false;
    for (int i = 1; i <= steps && !met; ++i) {
        to = float(i) / float(steps);
        vec3 place = position + to * way;
        vec3 seen = behind(pixelOf(place));
        float behindIt = distance(place, eye.xyz) - distance(seen, eye.xyz);
        met = behindIt > 0.0 && behindIt < thickness && inWater(seen);
        from = met ? from : to;
    }
    for (int i = 0; i < 6 && met; ++i) {
        float middle = 0.5 * (from + to);
        vec3 place = position + middle * way;
        bool beyond = distance(behind(pixelOf(place)), eye.xyz) < distance(place, eye.xyz);
        from = beyond ? from : middle;
        to = beyond ? middle : to;
    }
    return to;
}

// Bright lines that ripples throw on what lies below them, as a factor on its light.
float caustics(vec3 place) {
    vec2 at = place.xz - towardsSun.xz / towardsSun.y * place.y;
    float first = valueNoise(8.0 * at + vec2(0.8, 0.5) * time) + 0.5 * valueNoise(19.0 * at.yx - vec2(0.9, 1.1) * time);
    return 1.0 + 0.30 * (exp(-90.0 * first * first) - 0.25);
}

void main() {
    vec3 towardsEye = normalize(eye.xyz - position);
    if (dot(normal, towardsEye) <= 0.0) {
        discard;
    }
    bool onTop = normal.y > 0.5;
    vec3 facing = onTop ? rippled() : normal;
    vec3 into = refract(-towardsEye, facing, 1.0 / 1.33);
    vec3 way = wayThrough(into) * into;
    vec3 met = position + firstMet(way) * way;
    ivec2 pixel = pixelOf(met);
    // What stands in front of the water is not seen through it, but what is beside it on the screen.
    for (int i = 0; i < 4 && dot(behind(pixel) - position, normal) > 0.0; ++i) {
        pixel.y = max(pixel.y - textureSize(scene, 0).y / 90, 0);
    }
    vec3 below = texelFetch(scene, pixel, 0).rgb;
    // Light came down through the water before it came up.
    float down = clamp(centre.y + extents.y - met.y, 0.0, 2.0 * extents.y);
    vec3 kept = exp(-absorption * (distance(met, position) + down));
    if (inWater(behind(pixel))) {
        below *= mix(1.0, caustics(met), smoothstep(0.0, 0.15, down));
    }
    below = below * kept + scattered * (1.0 - kept);

    Surface s;
    s.position = position;
    s.normal = facing;
    s.reflectance = onTop ? 0.02 : 0.04;
    s.roughness = 0.12;
    float facingEye = max(dot(facing, towardsEye), 0.02);
    float facingSun = max(dot(facing, towardsSun.xyz), 0.0);
    vec3 mirrored = mirroredLight(reflect(-towardsEye, facing), s.roughness);
    vec3 glint =
        sunLight * sunVisible(position, normal) * facingSun * sunGlint(s, towardsEye, facingSun, facingEye);
    float share = fresnel(s.reflectance, facingEye);
    colour = vec4(below * (1.0 - share) + toneMapped(share * mirrored + glint), 1.0);
}
)";

}  // namespace drench::viewer::shaders
