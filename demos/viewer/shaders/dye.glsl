// Transmittance of dyed cloth: the layer of Kubelka and Munk with the absorption that follows from its
// albedo, for a given transmittance without absorption. The path of light that is scattered, or reflected
// back into the cloth at its surface, is `detour` times as long.
vec3 passingDye(vec3 albedo, float transmittance, float detour) {
    float scattering = detour * (1.0 / max(transmittance, 1e-3) - 1.0);
    vec3 a = 1.0 + (1.0 - albedo) * (1.0 - albedo) / (2.0 * max(albedo, 1e-3));
    vec3 b = sqrt(a * a - 1.0) + 1e-4;
    vec3 grown = exp(min(b * scattering, 40.0));
    return 2.0 * b / ((a + b) * grown + (b - a) / grown);
}
