// A square that covers the ball round the patch, facing the eye.
layout(location = 0) in vec4 centreAndRadius;
layout(location = 1) in vec4 orientation;
layout(location = 2) in vec4 wetnessAndOutline;
flat out vec4 ball;
flat out vec4 turn;
flat out vec2 kind;

void main() {
    const float margin = 1.35;
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    vec3 towardsEye = normalize(eye.xyz - centreAndRadius.xyz);
    vec3 helper = abs(towardsEye.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    vec3 right = normalize(cross(helper, towardsEye));
    vec3 up = cross(towardsEye, right);
    ball = centreAndRadius;
    turn = orientation;
    kind = wetnessAndOutline.xy;
    vec3 place = ball.xyz + margin * ball.w * (corner.x * right + corner.y * up);
    gl_Position = clipFromWorld * vec4(place, 1.0);
}
