// Where things are: GLSL source pieces.
#pragma once

namespace drench::viewer::shaders {

// The place of what is drawn already.
inline constexpr char placeBehind[] = R"(
uniform sampler2D sceneDepth;

vec3 placeBehind(ivec2 pixel) {
    vec2 size = vec2(textureSize(sceneDepth, 0));
    vec3 clip = vec3((vec2(pixel) + 0.5) / size, texelFetch(sceneDepth, pixel, 0).r) * 2.0 - 1.0;
    vec4 offset = offsetFromClip * vec4(clip, 1.0);
    return eye.xyz + offset.xyz / offset.w;
}
)";

// A vector turned by a quaternion of unit length.
inline constexpr char turning[] = R"(
vec3 turned(vec3 vector, vec4 turn) {
    return vector + 2.0 * cross(turn.xyz, cross(turn.xyz, vector) + turn.w * vector);
}
)";

}  // namespace drench::viewer::shaders
