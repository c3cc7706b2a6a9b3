// The ground, the sky and the way to the screen: GLSL source pieces.
#pragma once

namespace drench::viewer::shaders {

// One large square of ground with the eye above its middle.
inline constexpr char groundVertex[] = R"(
out vec3 position;

void main() {
    const float reach = 250.0;
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    position = vec3(eye.x + reach * corner.x, ground.x, eye.z + reach * corner.y);
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
)";

inline constexpr char groundFragment[] = R"(
in vec3 position;
out vec4 colour;

// 1 on the lines between squares of one metre, averaged over the width of the pixel.
float gridLine(vec2 at) {
    const float halfWidth = 0.008;
    vec2 pixel = max(fwidth(at), 1e-5);
    vec2 away = abs(fract(at - 0.5) - 0.5);
    vec2 covered = clamp((halfWidth + 0.5 * pixel - away) / pixel, 0.0, 1.0);
    covered *= min(2.0 * halfWidth / pixel, 1.0);
    // Where a pixel is wider than a square only the average is left, and far away not even that.
    covered *= 1.0 - smoothstep(0.15, 0.6, pixel);
    return max(covered.x, covered.y);
}

void main() {
    const vec3 up = vec3(0.0, 1.0, 0.0);
    float uneven = valueNoise(0.7 * position.xz) + 0.6 * valueNoise(2.3 * position.xz + 5.7);
    uneven *= 1.0 - smoothstep(0.1, 0.5, max(fwidth(position.x), fwidth(position.z)));
    vec3 albedo = groundAlbedo * (1.0 + 0.10 * uneven) * (1.0 - 0.30 * gridLine(position.xz));
    vec3 sun = sunLight * towardsSun.y * sunVisible(position, up);
    vec3 light = albedo * (sun + ambientLight(up) * opennessAmongBalls(position, up));
    vec3 away = position - eye.xyz;
    float haze = 1.0 - exp(-pow(length(away) / 75.0, 1.5));
    vec3 level = normalize(vec3(away.x, 0.0, away.z) + vec3(1e-6));
    colour = vec4(toneMapped(mix(light, skyLight(level), haze)), 1.0);
}
)";

// One triangle over the whole picture, behind everything.
inline constexpr char fullScreenVertex[] = R"(
out vec2 screen;

void main() {
    screen = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(screen, 1.0, 1.0);
}
)";

inline constexpr char skyFragment[] = R"(
in vec2 screen;
out vec4 colour;

// Thin uneven cloud on a level sheet high up.
float clouds(vec3 direction) {
    vec2 at = direction.xz / (max(direction.y, 0.0) + 0.25) * 1.7;
    return valueNoise(at) + 0.5 * valueNoise(2.1 * at + 7.3) + 0.25 * valueNoise(4.3 * at + 2.9);
}

void main() {
    vec4 ray = worldFromClip * vec4(screen, 1.0, 1.0);
    vec3 direction = normalize(ray.xyz / ray.w);
    float clear = smoothstep(0.0, 0.35, direction.y);
    vec3 light = skyLight(direction) * (1.0 + 0.16 * clear * clouds(direction));
    colour = vec4(toneMapped(light), 1.0);
}
)";

// Linear light to sRGB bytes, with half a step of dither so that the sky has no bands.
inline constexpr char presentFragment[] = R"(
in vec2 screen;
uniform sampler2D scene;
out vec4 colour;

vec3 encoded(vec3 light) {
    vec3 low = 12.92 * light;
    vec3 high = 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055;
    return mix(low, high, step(vec3(0.0031308), light));
}

void main() {
    vec3 light = clamp(texelFetch(scene, ivec2((0.5 * screen + 0.5) * vec2(textureSize(scene, 0))), 0).rgb, 0.0, 1.0);
    float dither = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
    colour = vec4(encoded(light) + dither / 255.0, 1.0);
}
)";

}  // namespace drench::viewer::shaders
