// Scale of drops, streaks and mist on the screen, and lookups in the finished picture.
uniform sampler2D scene;

float metresPerPixel(vec3 place) {
    return lens.z * distance(place, eye.xyz);
}
