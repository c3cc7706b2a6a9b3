out vec2 passing;

void main() {
    passing = vec2(1.0, gl_FragCoord.z);
}
