// Blended by minimum: the fraction of the sunlight that sheets transmit, and the depth of the nearest solid.
in vec3 albedo;
in float transmittance;
out vec2 passing;

void main() {
    float bright = dot(passingDye(albedo, transmittance, 2.0), vec3(0.2126, 0.7152, 0.0722));
    passing = vec2(min(bright, transmittance), 1.0);
}
