// An opaque material under a smooth coat (F0, roughness), lit by the sun and the sky.
struct Surface {
    vec3 position;
    vec3 normal;
    vec3 albedo;
    float reflectance;
    float roughness;
    float openness;
};

float fresnel(float reflectance, float cosine) {
    float away = 1.0 - cosine;
    float square = away * away;
    return reflectance + (1.0 - reflectance) * square * square * away;
}

// The GGX lobe with Smith's shadowing term, times pi because sunLight is divided by it.
float sunGlint(Surface s, vec3 towardsEye, float facingSun, float facingEye) {
    vec3 halfway = normalize(towardsEye + towardsSun.xyz);
    float a2 = pow(s.roughness, 4.0);
    float facingHalf = max(dot(s.normal, halfway), 0.0);
    float spread = facingHalf * facingHalf * (a2 - 1.0) + 1.0;
    float visibility = 0.5 / (facingSun * sqrt(a2 + (1.0 - a2) * facingEye * facingEye) +
                              facingEye * sqrt(a2 + (1.0 - a2) * facingSun * facingSun) + 1e-4);
    return fresnel(s.reflectance, max(dot(towardsEye, halfway), 0.0)) * a2 / (spread * spread) * visibility;
}

vec3 shaded(Surface s) {
    vec3 towardsEye = normalize(eye.xyz - s.position);
    float facingEye = max(dot(s.normal, towardsEye), 0.02);
    float facingSun = max(dot(s.normal, towardsSun.xyz), 0.0);
    vec3 sun = sunLight() * sunVisible(s.position, s.normal);

    vec3 front = sun * facingSun + ambientLight(s.normal) * s.openness;
    vec3 colour = s.albedo * front;

    // Rough surfaces lose most of the grazing shine.
    float smoothness = 1.0 - s.roughness;
    float shine = s.reflectance + (fresnel(s.reflectance, facingEye) - s.reflectance) * smoothness;
    colour += shine * s.openness * mirroredLight(reflect(-towardsEye, s.normal), s.roughness);
    colour += sun * facingSun * sunGlint(s, towardsEye, facingSun, facingEye);
    return colour;
}
