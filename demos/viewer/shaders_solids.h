// How balls, rods and boxes are drawn: GLSL source pieces.
#pragma once

namespace drench::viewer::shaders {

inline constexpr char ballVertex[] = R"(
layout(location = 0) in vec4 unitSphere;
layout(location = 1) in vec4 centreAndRadius;
layout(location = 2) in vec4 orientation;
layout(location = 3) in vec4 paint;
out vec3 position;
out vec3 normal;
out vec3 onBall;
flat out vec3 albedo;

vec3 turned(vec3 vector, vec4 turn) {
    return vector + 2.0 * cross(turn.xyz, cross(turn.xyz, vector) + turn.w * vector);
}

void main() {
    onBall = unitSphere.xyz;
    normal = turned(onBall, orientation);
    position = centreAndRadius.xyz + centreAndRadius.w * normal;
    albedo = paint.rgb;
    gl_Position = clipFromWorld * vec4(position, 1.0);
    // Cloth that lies on the ball wins against it: the depth, not the place, of a point 3 mm farther away.
    if (gl_Position.w > 0.01) {
        vec4 behind = clipFromWorld * vec4(position + 0.003 * normalize(position - eye.xyz), 1.0);
        gl_Position.z = behind.z / behind.w * gl_Position.w;
    }
}
)";

inline constexpr char ballFragment[] = R"(
in vec3 position;
in vec3 normal;
in vec3 onBall;
flat in vec3 albedo;
out vec4 colour;

// 1 on the six panels and the two caps that are dark, 0 elsewhere, with edges one pixel wide.
float darkPanel(vec3 at) {
    // The sine of three times the longitude, without the seam that an angle has.
    float wave = at.z * (3.0 * at.x * at.x - at.z * at.z);
    float panel = smoothstep(-0.7, 0.7, wave / max(fwidth(wave), 1e-5));
    float cap = (abs(at.y) - 0.93) / max(fwidth(at.y), 1e-5);
    return mix(panel, 1.0, smoothstep(-0.7, 0.7, cap));
}

void main() {
    Surface s;
    s.position = position;
    s.normal = normalize(normal);
    vec3 pale = mix(albedo, vec3(0.80, 0.78, 0.72), 0.85);
    s.albedo = mix(pale, albedo, darkPanel(normalize(onBall)));
    s.reflectance = 0.04;
    s.roughness = 0.42;
    s.translucency = 0.0;
    s.openness = opennessAboveGround(position, s.normal) * (0.72 + 0.28 * s.normal.y);
    colour = vec4(toneMapped(shaded(s)), 1.0);
}
)";

inline constexpr char rodVertex[] = R"(
layout(location = 0) in vec4 unitCapsule;
layout(location = 1) in vec4 fromAndRadius;
layout(location = 2) in vec4 to;
layout(location = 3) in vec4 paint;
out vec3 position;
out vec3 normal;
flat out vec3 albedo;

void main() {
    vec3 along = to.xyz - fromAndRadius.xyz;
    vec3 up = length(along) > 1e-6 ? normalize(along) : vec3(0.0, 1.0, 0.0);
    vec3 right = normalize(cross(up, abs(up.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
    normal = mat3(right, up, cross(right, up)) * unitCapsule.xyz;
    position = fromAndRadius.xyz + along * unitCapsule.w + fromAndRadius.w * normal;
    albedo = paint.rgb;
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
)";

inline constexpr char rodFragment[] = R"(
in vec3 position;
in vec3 normal;
flat in vec3 albedo;
out vec4 colour;

void main() {
    Surface s;
    s.position = position;
    s.normal = normalize(normal);
    s.albedo = albedo;
    s.reflectance = 0.04;
    s.roughness = 0.6;
    s.translucency = 0.0;
    s.openness = opennessAboveGround(position, s.normal);
    colour = vec4(toneMapped(shaded(s)), 1.0);
}
)";

inline constexpr char boxVertex[] = R"(
layout(location = 0) in vec4 cornerAndAxis;
layout(location = 1) in vec4 centre;
layout(location = 2) in vec4 orientation;
layout(location = 3) in vec4 paint;
layout(location = 4) in vec4 halfExtents;
out vec3 position;
flat out vec3 normal;
flat out vec3 albedo;

vec3 turned(vec3 vector, vec4 turn) {
    return vector + 2.0 * cross(turn.xyz, cross(turn.xyz, vector) + turn.w * vector);
}

void main() {
    vec3 corner = cornerAndAxis.xyz;
    vec3 face = corner * vec3(equal(ivec3(0, 1, 2), ivec3(int(cornerAndAxis.w + 0.5))));
    normal = turned(face, orientation);
    position = centre.xyz + turned(halfExtents.xyz * corner, orientation);
    albedo = paint.rgb;
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
)";

// As on a ball, cloth that lies on the box wins against it; here pixel by pixel, since corners are far apart.
inline constexpr char boxFragment[] = R"(
in vec3 position;
flat in vec3 normal;
flat in vec3 albedo;
out vec4 colour;

void main() {
    Surface s;
    s.position = position;
    s.normal = normalize(normal);
    s.albedo = albedo;
    s.reflectance = 0.04;
    s.roughness = 0.8;
    s.translucency = 0.0;
    s.openness = opennessAboveGround(position, s.normal);
    colour = vec4(toneMapped(shaded(s)), 1.0);
    vec4 behind = clipFromWorld * vec4(position + 0.003 * normalize(position - eye.xyz), 1.0);
    gl_FragDepth = 0.5 + 0.5 * behind.z / behind.w;
}
)";

}  // namespace drench::viewer::shaders
