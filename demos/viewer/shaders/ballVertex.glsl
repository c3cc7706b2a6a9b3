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
    // Cloth that lies on the ball must be drawn over it: the depth (not the position) is that of a point 3 mm
    // farther away.
    if (gl_Position.w > 0.01) {
        vec4 behind = clipFromWorld * vec4(position + 0.003 * normalize(position - eye.xyz), 1.0);
        gl_Position.z = behind.z / behind.w * gl_Position.w;
    }
}
