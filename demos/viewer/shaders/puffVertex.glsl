layout(location = 0) in vec4 centreAndRadius;
layout(location = 1) in vec4 density;
out vec2 onPuff;
out vec3 position;
flat out vec4 ball;
flat out float thickness;
flat out float sun;

void main() {
    ball = centreAndRadius;
    thickness = density.x;
    sun = sunAt(ball.xyz);
    vec3 towardsEye = normalize(eye.xyz - ball.xyz);
    vec3 helper = abs(towardsEye.y) < 0.95 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    vec3 right = normalize(cross(helper, towardsEye));
    onPuff = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    position = ball.xyz + ball.w * (onPuff.x * right + onPuff.y * cross(towardsEye, right));
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
