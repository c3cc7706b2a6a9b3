in vec3 position;
in vec3 normal;
in vec3 onBall;
flat in float radius;
flat in vec3 albedo;
flat in int material;
out vec4 colour;

// Distance of a position inside the six panels and the two caps that are dark, as a fraction of the radius;
// negative outside.
float insideDark(vec3 at) {
    // The sine of three times the longitude, without the discontinuity of an angle.
    float wave = at.z * (3.0 * at.x * at.x - at.z * at.z);
    float panel = wave / (3.0 * max(dot(at.xz, at.xz), 0.02));
    return max(panel, abs(at.y) - 0.93);
}

void main() {
    vec3 at = normalize(onBall);
    vec3 albedoHere = albedo;
    float groove = 0.0;
    if (material == paint) {
        float inside = insideDark(at);
        float pixel = max(length(dFdx(at)), length(dFdy(at)));
        vec3 pale = mix(albedo, vec3(0.80, 0.78, 0.72), 0.85);
        albedoHere = mix(pale, albedo, smoothstep(-0.7, 0.7, inside / max(pixel, 1e-5)));
        // The rubber is pressed in a little where two colours meet.
        groove = exp(-pow(inside / max(0.012, pixel), 2.0)) * min(0.012 / max(pixel, 1e-5), 1.0);
        albedoHere *= 1.0 - 0.45 * groove;
    }
    Finish finish = finishOf(material, at * radius, albedoHere, radius);
    finish.height -= 0.003 * radius * groove;
    vec3 smoothNormal = normalize(normal);
    float openness = opennessAboveGround(position, smoothNormal) * (0.72 + 0.28 * smoothNormal.y);
    colour = vec4(toneMapped(shadedSolid(material, finish, position, smoothNormal, openness)), 1.0);
}
