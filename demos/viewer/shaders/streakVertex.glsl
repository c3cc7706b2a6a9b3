// A thin quad along the streak, turned towards the eye.
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
