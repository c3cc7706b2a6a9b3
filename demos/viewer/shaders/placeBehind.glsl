// The position of the surface that is already drawn in a pixel.
uniform sampler2D sceneDepth;

vec3 placeBehind(ivec2 pixel) {
    vec2 size = vec2(textureSize(sceneDepth, 0));
    vec3 clip = vec3((vec2(pixel) + 0.5) / size, texelFetch(sceneDepth, pixel, 0).r) * 2.0 - 1.0;
    vec4 offset = offsetFromClip * vec4(clip, 1.0);
    return eye.xyz + offset.xyz / offset.w;
}
