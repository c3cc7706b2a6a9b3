// One large square of ground with the eye above its middle.
out vec3 position;

void main() {
    const float reach = 250.0;
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    position = vec3(eye.x + reach * corner.x, ground.x, eye.z + reach * corner.y);
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
