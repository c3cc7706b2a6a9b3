// How drops, streaks and mist are drawn: GLSL source pieces.
#pragma once

namespace drench::viewer::shaders {

// Their own scale on the screen, and the finished picture.
inline constexpr char airborne[] = R"(
uniform sampler2D scene;

float metresPerPixel(vec3 place) {
    return lens.z * distance(place, eye.xyz);
}
)";

// How much sun reaches a small thing in the air, in one look for all of its pixels.
inline constexpr char sunInAir[] = R"(
uniform sampler2DShadow sunShadow;

float sunAt(vec3 place) {
    vec3 map = (shadowFromWorld * vec4(place, 1.0)).xyz * 0.5 + 0.5;
    bool outside = any(lessThan(map.xy, vec2(0.0))) || any(greaterThan(map.xy, vec2(1.0)));
    return outside ? 1.0 : textureLod(sunShadow, vec3(map.xy, min(map.z, 0.99999)), 0.0);
}
)";

// A square across the line of sight, as long as the drop moves while the picture is exposed.
inline constexpr char dropVertex[] = R"(
layout(location = 0) in vec4 centreAndRadius;
layout(location = 1) in vec4 drawnOut;
out vec2 onDrop;
flat out vec3 centre;
flat out vec3 along;
flat out vec3 across;
flat out vec3 towardsEye;
flat out float opacity;
flat out float sun;
flat out float slimness;

void main() {
    centre = centreAndRadius.xyz;
    towardsEye = normalize(eye.xyz - centre);
    sun = sunAt(centre);
    float smallest = 0.75 * metresPerPixel(centre);
    float radius = max(centreAndRadius.w, smallest);
    // What is too small for a pixel fills one in part.
    opacity = pow(centreAndRadius.w / radius, 1.5);
    vec3 seen = drawnOut.xyz - dot(drawnOut.xyz, towardsEye) * towardsEye;
    float halfWay = 0.5 * length(seen);
    vec3 helper = abs(towardsEye.y) < 0.95 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    helper = normalize(helper - dot(helper, towardsEye) * towardsEye);
    along = halfWay > 1e-6 ? 0.5 * seen / halfWay : helper;
    across = cross(along, towardsEye);
    float halfLength = radius + halfWay;
    slimness = radius / halfLength;
    // It is in each place for a part of the exposure only.
    opacity *= mix(0.6, 1.0, slimness);
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    // Leaves room for a smooth edge.
    onDrop = corner * (1.0 + vec2(smallest / radius, smallest / halfLength));
    vec3 place = centre + onDrop.x * radius * across + onDrop.y * halfLength * along;
    gl_Position = clipFromWorld * vec4(place, 1.0);
}
)";

// A clear ball: light from behind is bent twice and shows the world upside down, the rim mirrors the sky.
inline constexpr char dropFragment[] = R"(
in vec2 onDrop;
flat in vec3 centre;
flat in vec3 along;
flat in vec3 across;
flat in vec3 towardsEye;
flat in float opacity;
flat in float sun;
flat in float slimness;
out vec4 colour;

// The finished picture in a direction from the drop; what it does not show is the light of the sky and the
// ground.
vec3 lookedUp(vec3 direction) {
    const float reach = 1.2;
    vec4 clip = clipFromWorld * vec4(centre + reach * direction, 1.0);
    vec2 at = clip.xy / max(clip.w, 1e-3) * 0.5 + 0.5;
    vec3 around = toneMapped(mirroredLight(direction, 0.1));
    vec2 inside = smoothstep(0.5, 0.46, abs(at - 0.5));
    float known = clip.w > 0.0 ? inside.x * inside.y : 0.0;
    ivec2 size = textureSize(scene, 0);
    vec3 seen = texelFetch(scene, ivec2(clamp(at, 0.0, 0.999) * vec2(size)), 0).rgb;
    return mix(around, seen, known);
}

void main() {
    float out2 = dot(onDrop, onDrop);
    float outside = sqrt(out2);
    float pixel = max(fwidth(outside), 1e-4);
    float covered = clamp((1.0 - outside) / pixel + 0.5, 0.0, 1.0);
    if (covered <= 0.0) {
        discard;
    }
    float towards = sqrt(max(1.0 - out2, 0.0));
    vec3 sideways = onDrop.x * across + slimness * onDrop.y * along;
    vec3 normal = normalize(sideways + max(towards, 0.02) * towardsEye);
    vec3 inwards = refract(-towardsEye, normal, 1.0 / 1.33);
    vec3 farSide = normalize(normal - 2.0 * dot(normal, inwards) * inwards);
    vec3 outwards = refract(inwards, farSide, 1.33);
    outwards = dot(outwards, outwards) > 0.0 ? outwards : reflect(inwards, farSide);
    vec3 through = lookedUp(outwards);

    vec3 mirror = reflect(-towardsEye, normal);
    float share = fresnel(0.02, max(dot(normal, towardsEye), 0.0));
    vec3 glint = sunLight() * sun * (6.0 * pow(max(dot(mirror, towardsSun.xyz), 0.0), 160.0) +
                                   1.2 * pow(max(dot(outwards, towardsSun.xyz), 0.0), 24.0));
    vec3 light = through * (1.0 - share) + toneMapped(share * mirroredLight(mirror, 0.05)) + glint;
    colour = vec4(min(light, 1.0), covered * opacity);
}
)";

// A thin quad along the streak, turned towards the eye.
inline constexpr char streakVertex[] = R"(
layout(location = 0) in vec4 fromAndWidth;
layout(location = 1) in vec4 toAndOpacity;
out vec2 onStreak;
flat out float opacity;
flat out vec3 middle;

void main() {
    vec3 way = toAndOpacity.xyz - fromAndWidth.xyz;
    middle = fromAndWidth.xyz + 0.5 * way;
    vec3 towardsEye = normalize(eye.xyz - middle);
    vec3 across = cross(way, towardsEye);
    float length2 = dot(across, across);
    across = length2 > 1e-12 ? across * inversesqrt(length2) : vec3(0.0);
    float width = max(fromAndWidth.w, 1.6 * metresPerPixel(middle));
    opacity = toAndOpacity.w * fromAndWidth.w / width;
    onStreak = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    vec3 place = middle + 0.5 * onStreak.y * way + onStreak.x * width * across;
    gl_Position = clipFromWorld * vec4(place, 1.0);
}
)";

// Drops of rain show a picture of most of the sky, wherever they are: pale against what is dark, dark against
// the sky.
inline constexpr char streakFragment[] = R"(
in vec2 onStreak;
flat in float opacity;
flat in vec3 middle;
out vec4 colour;

void main() {
    vec3 away = normalize(middle - eye.xyz);
    float intoSun = max(dot(away, towardsSun.xyz), 0.0);
    vec3 sky = 0.62 * mix(horizonLight, zenithLight, 0.4) + 0.5 * sunLight() * pow(intoSun, 8.0);
    float across = exp(-4.0 * onStreak.x * onStreak.x);
    float ends = 1.0 - onStreak.y * onStreak.y;
    colour = vec4(toneMapped(sky), opacity * across * ends);
}
)";

inline constexpr char puffVertex[] = R"(
layout(location = 0) in vec4 centreAndRadius;
layout(location = 1) in vec4 density;
out vec2 onPuff;
out vec3 position;
flat out vec4 ball;
flat out float thickness;
flat out float sun;

void main() {
    ball = centreAndRadius;
    thickness = density.x;
    sun = sunAt(ball.xyz);
    vec3 towardsEye = normalize(eye.xyz - ball.xyz);
    vec3 helper = abs(towardsEye.y) < 0.95 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    vec3 right = normalize(cross(helper, towardsEye));
    onPuff = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    position = ball.xyz + ball.w * (onPuff.x * right + onPuff.y * cross(towardsEye, right));
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
)";

// The way of the line of sight through the cloud, as far as nothing solid ends it.
inline constexpr char puffFragment[] = R"(
in vec2 onPuff;
in vec3 position;
flat in vec4 ball;
flat in float thickness;
flat in float sun;
out vec4 colour;

void main() {
    float inside = 1.0 - dot(onPuff, onPuff);
    if (inside <= 0.0) {
        discard;
    }
    vec3 solid = placeBehind(ivec2(gl_FragCoord.xy));
    float beforeSolid = distance(solid, eye.xyz) - distance(position, eye.xyz);
    float reach = ball.w * sqrt(inside);
    float open = clamp(0.5 + 0.5 * beforeSolid / max(reach, 1e-5), 0.0, 1.0);
    // Clouds are uneven, and fade out at their rims.
    float uneven = 1.0 + 1.2 * valueNoise(11.0 * position) + 0.7 * valueNoise(27.0 * position);
    float optical = -log(1.0 - min(thickness, 0.98)) * inside * inside * max(uneven, 0.0) * open;

    vec3 away = normalize(position - eye.xyz);
    float intoSun = dot(away, towardsSun.xyz);
    // Henyey and Greenstein's phase function of droplets that scatter forwards, 1 on average.
    const float g = 0.6;
    float phase = (1.0 - g * g) / pow(1.0 + g * g - 2.0 * g * intoSun, 1.5);
    vec3 light = 0.85 * ambientLight(vec3(0.0, 1.0, 0.0)) + 0.35 * phase * sun * sunLight();
    colour = vec4(toneMapped(light), 1.0 - exp(-optical));
}
)";

}  // namespace drench::viewer::shaders
