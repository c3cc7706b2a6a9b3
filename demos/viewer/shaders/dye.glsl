// What passes dyed cloth.
// The layer of Kubelka and Munk with the absorption that its albedo tells, of a transmittance that is without any.
// Light that is scattered, or thrown back into the cloth where it would leave it into air, takes `detour` times the way.
vec3 passingDye(vec3 albedo, float transmittance, float detour) {
    float scattering = detour * (1.0 / max(transmittance, 1e-3) - 1.0);
    vec3 a = 1.0 + (1.0 - albedo) * (1.0 - albedo) / (2.0 * max(albedo, 1e-3));
    vec3 b = sqrt(a * a - 1.0) + 1e-4;
    vec3 grown = exp(min(b * scattering, 40.0));
    return 2.0 * b / ((a + b) * grown + (b - a) / grown);
}
