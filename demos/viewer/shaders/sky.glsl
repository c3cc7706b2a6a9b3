// An overcast bright day: a weak, soft sun and a strong sky. Irradiances are divided by pi.
const vec3 horizonLight = vec3(0.86, 0.885, 0.90);
const vec3 zenithLight = vec3(0.43, 0.55, 0.70);
const vec3 groundAlbedo = vec3(0.235, 0.236, 0.200);

// What passes the clouds.
vec3 sunLight() {
    return towardsSun.w * vec3(0.86, 0.80, 0.71);
}

vec3 skyLight(vec3 direction) {
    // Clouds scatter downwards part of the light that they keep from the sun, grey all over.
    const vec3 cloud = vec3(0.66, 0.70, 0.74);
    vec3 zenith = mix(cloud, zenithLight, towardsSun.w);
    vec3 horizon = mix(0.9, 1.0, towardsSun.w) * horizonLight;
    vec3 light = mix(horizon, zenith, pow(max(direction.y, 0.0), 0.55));
    float aside = 1.0 - max(dot(direction, towardsSun.xyz), 0.0);
    return light + 0.30 * sunLight() * exp(-9.0 * aside);
}

// What a surface mirrors: the sky above, the lit ground below, blended the more the rougher it is.
vec3 mirroredLight(vec3 direction, float roughness) {
    float blur = 0.04 + 0.9 * roughness * roughness;
    vec3 below = groundAlbedo * 0.9;
    // The haze round the sun is far brighter than the screen can show, and a mirror tells.
    float aside = 1.0 - max(dot(direction, towardsSun.xyz), 0.0);
    vec3 glow = 1.8 * sunLight() * exp(-5.0 * aside);
    return mix(below, glow + 1.3 * skyLight(normalize(direction + vec3(0.0, 0.4 * roughness, 0.0))),
               smoothstep(-blur, blur, direction.y));
}

// Light from the whole upper or lower half space onto a surface that faces `normal`.
vec3 ambientLight(vec3 normal) {
    const vec3 above = vec3(0.50, 0.55, 0.60);
    const vec3 below = vec3(0.215, 0.20, 0.175);
    return mix(1.25, 1.0, towardsSun.w) * mix(below, above, 0.5 + 0.5 * normal.y);
}

// Straight up to the knee, then bending towards 1: more light never gives a darker pixel.
vec3 toneMapped(vec3 light) {
    const float knee = 0.5;
    vec3 exposed = 1.14 * light;
    vec3 excess = max(exposed - knee, 0.0) / (1.0 - knee);
    return min(exposed, knee) + (1.0 - knee) * (1.0 - exp(-excess));
}

// The light that toneMapped made such a pixel of.
vec3 beforeToneMapping(vec3 shown) {
    const float knee = 0.5;
    vec3 excess = -log(1.0 - clamp((shown - knee) / (1.0 - knee), 0.0, 0.995));
    return (min(shown, knee) + (1.0 - knee) * excess) / 1.14;
}
