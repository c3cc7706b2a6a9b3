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
