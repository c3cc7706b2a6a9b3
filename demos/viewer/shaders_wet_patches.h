// How wet patches get onto the solids: GLSL source pieces.
#pragma once

namespace drench::viewer::shaders {

// A square that covers the ball round the patch, facing the eye.
inline constexpr char patchVertex[] = R"(
layout(location = 0) in vec4 centreAndRadius;
layout(location = 1) in vec4 orientation;
layout(location = 2) in vec4 wetnessAndOutline;
flat out vec4 ball;
flat out vec4 turn;
flat out vec2 kind;

void main() {
    const float margin = 1.35;
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    vec3 towardsEye = normalize(eye.xyz - centreAndRadius.xyz);
    vec3 helper = abs(towardsEye.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    vec3 right = normalize(cross(helper, towardsEye));
    vec3 up = cross(towardsEye, right);
    ball = centreAndRadius;
    turn = orientation;
    kind = wetnessAndOutline.xy;
    vec3 place = ball.xyz + margin * ball.w * (corner.x * right + corner.y * up);
    gl_Position = clipFromWorld * vec4(place, 1.0);
}
)";

// Looks up which place a solid has in this pixel, and how wet the patch makes it.
inline constexpr char patchFragment[] = R"(
flat in vec4 ball;
flat in vec4 turn;
flat in vec2 kind;
out vec4 colour;

void main() {
    vec4 back = vec4(-turn.xyz, turn.w);
    vec3 within = turned(placeBehind(ivec2(gl_FragCoord.xy)) - ball.xyz, back) / ball.w;
    vec3 shape = within + 61.0 * kind.y;
    float uneven = 0.75 * valueNoise(1.9 * shape) + 0.40 * valueNoise(4.6 * shape);
    uneven += 0.15 * valueNoise(12.0 * shape);
    float outwards = length(within) * max(1.12 + uneven, 0.8);
    float wet = kind.x * (1.0 - smoothstep(0.45, 1.03, outwards));
    colour = vec4(wet);
}
)";

}  // namespace drench::viewer::shaders
