// Light on cloth: diffuse from its front, through it from behind, fibres that catch light at its rim while it is dry,
// and the mirror of a film where water stands on it.
// Fuzz after Estevez and Kulla (2017), with the visibility of Neubelt and Pettineo (2013), times pi.
float fuzz(vec3 normal, vec3 towardsEye, float facingSun, float facingEye) {
    const float inverseWidth = 1.0 / 0.45;
    float facingHalf = dot(normal, normalize(towardsEye + towardsSun.xyz));
    float sine = sqrt(max(1.0 - facingHalf * facingHalf, 0.0));
    float density = 0.5 * (2.0 + inverseWidth) * pow(sine, inverseWidth);
    return density / (4.0 * (facingSun + facingEye - facingSun * facingEye) + 1e-3);
}

struct Cloth {
    vec3 position;
    // With threads and creases, and of the film over them.
    vec3 normal;
    vec3 filmNormal;
    vec3 albedo;
    float transmittance;
    // Fraction covered by a film, and its roughness.
    float film;
    float roughness;
    // 1 where fibres stand off, 0 where water lays them.
    float dryness;
    float openness;
};

vec3 diffuseLight(Cloth c, vec3 sun, float towards) {
    vec3 front = sun * max(towards, 0.0) + ambientLight(c.normal) * c.openness;
    vec3 back = sun * max(-towards, 0.0) + ambientLight(-c.normal) * c.openness;
    float clear = clearness(c.transmittance);
    vec4 behind = lightBehind(clear);
    // An object in contact with the cloth is visible however much the cloth scatters. Cloth that lies on a
    // solid is drawn up to a centimetre away from it.
    float touching = 1.0 - smoothstep(0.012, 0.03, behind.w);
    // The sky that the cloth hides still lights it.
    behind.rgb *= 1.0 - 0.25 * touching;
    // Between dry threads there are gaps, which water closes to light as it does to air.
    vec3 tint = c.albedo / max(max(c.albedo.r, c.albedo.g), max(c.albedo.b, 1e-3));
    vec3 gaps = 0.35 * c.dryness * c.dryness * c.transmittance * tint;
    vec3 passing = min(passingDye(c.albedo, c.transmittance, mix(2.0, 1.1, touching)) + gaps, 1.0 - c.albedo);
    // Another layer of cloth hides what is behind it, and shows itself.
    vec3 beyond = mix(c.albedo * back, behind.rgb, otherLayers(c.transmittance));
    return c.albedo * front + passing * mix(back, beyond, mix(clear, 1.0, touching));
}

vec3 clothLight(Cloth c) {
    vec3 towardsEye = normalize(eye.xyz - c.position);
    float facingEye = max(dot(c.normal, towardsEye), 0.02);
    float towards = dot(c.normal, towardsSun.xyz);
    float facingSun = max(towards, 0.0);
    vec3 sun = sunLight() * sunVisible(c.position, c.filmNormal);
    vec3 colour = diffuseLight(c, sun, towards);

    float rim = pow(max(1.0 - facingEye, 0.0), 3.0);
    float fibres = 0.10 * c.dryness;
    vec3 haze = fibres * sqrt(c.albedo);
    colour *= 1.0 - fibres * rim;
    colour += haze * (sun * facingSun * fuzz(c.normal, towardsEye, facingSun, facingEye) +
                      rim * c.openness * ambientLight(c.normal));

    Surface film;
    film.normal = c.filmNormal;
    film.reflectance = 0.02;
    film.roughness = c.roughness;
    float filmFacingEye = max(dot(c.filmNormal, towardsEye), 0.02);
    float filmFacingSun = max(dot(c.filmNormal, towardsSun.xyz), 0.0);
    float mirror = 0.02 + (fresnel(0.02, filmFacingEye) - 0.02) * (1.0 - c.roughness);
    colour *= 1.0 - c.film * mirror;
    colour += c.film * mirror * c.openness * mirroredLight(reflect(-towardsEye, c.filmNormal), c.roughness);
    colour += c.film * sun * filmFacingSun * sunGlint(film, towardsEye, filmFacingSun, filmFacingEye);
    return colour;
}
