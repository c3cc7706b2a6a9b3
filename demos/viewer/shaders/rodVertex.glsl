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
