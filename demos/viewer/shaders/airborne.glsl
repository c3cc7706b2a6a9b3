// Their own scale on the screen, and the finished picture.
uniform sampler2D scene;

float metresPerPixel(vec3 place) {
    return lens.z * distance(place, eye.xyz);
}
