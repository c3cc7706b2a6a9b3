layout(location = 0) in vec4 cornerAndAxis;
layout(location = 1) in vec4 centreAndTime;
layout(location = 4) in vec4 halfExtents;
out vec3 position;
flat out vec3 normal;
flat out vec3 centre;
flat out vec3 extents;
flat out float time;

void main() {
    vec3 corner = cornerAndAxis.xyz;
    normal = corner * vec3(equal(ivec3(0, 1, 2), ivec3(int(cornerAndAxis.w + 0.5))));
    centre = centreAndTime.xyz;
    extents = halfExtents.xyz;
    time = centreAndTime.w;
    position = centre + extents * corner;
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
