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
flat out float radius;
flat out vec3 albedo;
flat out int material;

void main() {
    onBall = unitSphere.xyz;
    normal = turned(onBall, orientation);
    position = centreAndRadius.xyz + centreAndRadius.w * normal;
    radius = centreAndRadius.w;
    albedo = paint.rgb;
    material = int(paint.a + 0.5);
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
flat in float radius;
flat in vec3 albedo;
flat in int material;
out vec4 colour;

// How far a place is inside the six panels and the two caps that are dark, as a share of the radius; below 0
// outside.
float insideDark(vec3 at) {
    // The sine of three times the longitude, without the seam that an angle has.
    float wave = at.z * (3.0 * at.x * at.x - at.z * at.z);
    float panel = wave / (3.0 * max(dot(at.xz, at.xz), 0.02));
    return max(panel, abs(at.y) - 0.93);
}

void main() {
    vec3 at = normalize(onBall);
    vec3 albedoHere = albedo;
    float groove = 0.0;
    if (material == paint) {
        float inside = insideDark(at);
        float pixel = max(length(dFdx(at)), length(dFdy(at)));
        vec3 pale = mix(albedo, vec3(0.80, 0.78, 0.72), 0.85);
        albedoHere = mix(pale, albedo, smoothstep(-0.7, 0.7, inside / max(pixel, 1e-5)));
        // The rubber is pressed in a little where two colours meet.
        groove = exp(-pow(inside / max(0.012, pixel), 2.0)) * min(0.012 / max(pixel, 1e-5), 1.0);
        albedoHere *= 1.0 - 0.45 * groove;
    }
    Finish finish = finishOf(material, at * radius, albedoHere, radius);
    finish.height -= 0.003 * radius * groove;
    vec3 smoothNormal = normalize(normal);
    float openness = opennessAboveGround(position, smoothNormal) * (0.72 + 0.28 * smoothNormal.y);
    colour = vec4(toneMapped(shadedSolid(material, finish, position, smoothNormal, openness)), 1.0);
}
)";

inline constexpr char rodVertex[] = R"(
layout(location = 0) in vec4 unitCapsule;
layout(location = 1) in vec4 fromAndRadius;
layout(location = 2) in vec4 to;
layout(location = 3) in vec4 paint;
out vec3 position;
out vec3 normal;
out vec3 onRod;
flat out float radius;
flat out vec3 albedo;
flat out int material;

void main() {
    vec3 along = to.xyz - fromAndRadius.xyz;
    vec3 up = length(along) > 1e-6 ? normalize(along) : vec3(0.0, 1.0, 0.0);
    vec3 right = normalize(cross(up, abs(up.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
    normal = mat3(right, up, cross(right, up)) * unitCapsule.xyz;
    position = fromAndRadius.xyz + along * unitCapsule.w + fromAndRadius.w * normal;
    radius = fromAndRadius.w;
    onRod = radius * unitCapsule.yxz;
    onRod.x += length(along) * unitCapsule.w;
    albedo = paint.rgb;
    material = int(paint.a + 0.5);
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
)";

inline constexpr char rodFragment[] = R"(
in vec3 position;
in vec3 normal;
in vec3 onRod;
flat in float radius;
flat in vec3 albedo;
flat in int material;
out vec4 colour;

void main() {
    vec3 smoothNormal = normalize(normal);
    Finish finish = finishOf(material, onRod, albedo, radius);
    float openness = opennessAboveGround(position, smoothNormal);
    colour = vec4(toneMapped(shadedSolid(material, finish, position, smoothNormal, openness)), 1.0);
}
)";

inline constexpr char boxVertex[] = R"(
layout(location = 0) in vec4 cornerAndAxis;
layout(location = 1) in vec4 centre;
layout(location = 2) in vec4 orientation;
layout(location = 3) in vec4 paint;
layout(location = 4) in vec4 halfExtents;
out vec3 position;
out vec3 inBox;
flat out vec3 normal;
flat out vec3 extents;
flat out vec3 albedo;
flat out int material;

void main() {
    vec3 corner = cornerAndAxis.xyz;
    vec3 face = corner * vec3(equal(ivec3(0, 1, 2), ivec3(int(cornerAndAxis.w + 0.5))));
    normal = turned(face, orientation);
    inBox = halfExtents.xyz * corner;
    position = centre.xyz + turned(inBox, orientation);
    extents = halfExtents.xyz;
    albedo = paint.rgb;
    material = int(paint.a + 0.5);
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
)";

// As on a ball, cloth that lies on the box wins against it; here pixel by pixel, since corners are far apart.
inline constexpr char boxFragment[] = R"(
in vec3 position;
in vec3 inBox;
flat in vec3 normal;
flat in vec3 extents;
flat in vec3 albedo;
flat in int material;
out vec4 colour;

// The sides of the box from the longest to the shortest, as x, y and z.
vec3 byLength(vec3 at, vec3 sides) {
    at = sides.x >= sides.y && sides.x >= sides.z ? at.xyz : sides.y >= sides.z ? at.yzx : at.zxy;
    sides = sides.x >= sides.y && sides.x >= sides.z ? sides.xyz : sides.y >= sides.z ? sides.yzx : sides.zxy;
    return sides.y >= sides.z ? at : at.xzy;
}

// A wide box is made of boards. Moves `at` into a piece of wood of its own for each, and tells how light that
// is and how much of the pixel is joint.
void findBoard(inout vec3 at, vec3 sides, out float lightness, out float joint) {
    const float widest = 0.14, halfJoint = 0.0022;
    float side = byLength(sides, sides).y;
    float count = ceil(2.0 * side / widest);
    float width = 2.0 * side / count;
    float board = clamp(floor((at.y + side) / width), 0.0, count - 1.0);
    float within = at.y + side - board * width;
    float pixel = max(fwidth(at.y), 1e-5);
    float covered = clamp((halfJoint + 0.5 * pixel - min(within, width - within)) / pixel, 0.0, 1.0);
    joint = count > 1.5 ? covered * min(2.0 * halfJoint / pixel, 1.0) : 0.0;
    lightness = 1.0 + 0.25 * latticeValue(vec2(board, 7.0));
    float shift = 0.06 * latticeValue(vec2(board, 3.0));
    at = vec3(at.x + 1.7 * board, within - 0.5 * width + shift, at.z + 0.03 * board);
}

void main() {
    vec3 at = byLength(inBox, extents);
    vec3 albedoHere = albedo;
    if (material == wood) {
        float lightness, joint;
        findBoard(at, extents, lightness, joint);
        albedoHere *= lightness * (1.0 - 0.75 * joint);
    }
    Finish finish = finishOf(material, at, albedoHere, min(extents.x, min(extents.y, extents.z)));
    float openness = opennessAboveGround(position, normal);
    colour = vec4(toneMapped(shadedSolid(material, finish, position, normal, openness)), 1.0);
    vec4 behind = clipFromWorld * vec4(position + 0.003 * normalize(position - eye.xyz), 1.0);
    gl_FragDepth = 0.5 + 0.5 * behind.z / behind.w;
}
)";

}  // namespace drench::viewer::shaders
