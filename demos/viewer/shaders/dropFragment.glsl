// A transparent ball: light from behind is refracted twice and shows the world upside down, the rim reflects
// the sky.
in vec2 onDrop;
flat in vec3 centre;
flat in vec3 along;
flat in vec3 across;
flat in vec3 towardsEye;
flat in float opacity;
flat in float sun;
flat in float slimness;
out vec4 colour;

// The finished picture in a direction from the drop; outside the picture, the light of the sky and the
// ground.
vec3 lookedUp(vec3 direction) {
    const float reach = 1.2;
    vec4 clip = clipFromWorld * vec4(centre + reach * direction, 1.0);
    vec2 at = clip.xy / max(clip.w, 1e-3) * 0.5 + 0.5;
    vec3 around = toneMapped(mirroredLight(direction, 0.1));
    vec2 inside = smoothstep(0.5, 0.46, abs(at - 0.5));
    float known = clip.w > 0.0 ? inside.x * inside.y : 0.0;
    ivec2 size = textureSize(scene, 0);
    vec3 seen = texelFetch(scene, ivec2(clamp(at, 0.0, 0.999) * vec2(size)), 0).rgb;
    return mix(around, seen, known);
}

void main() {
    float out2 = dot(onDrop, onDrop);
    float outside = sqrt(out2);
    float pixel = max(fwidth(outside), 1e-4);
    float covered = clamp((1.0 - outside) / pixel + 0.5, 0.0, 1.0);
    if (covered <= 0.0) discard;
    float towards = sqrt(max(1.0 - out2, 0.0));
    vec3 sideways = onDrop.x * across + slimness * onDrop.y * along;
    vec3 normal = normalize(sideways + max(towards, 0.02) * towardsEye);
    vec3 inwards = refract(-towardsEye, normal, 1.0 / 1.33);
    vec3 farSide = normalize(normal - 2.0 * dot(normal, inwards) * inwards);
    vec3 outwards = refract(inwards, farSide, 1.33);
    outwards = dot(outwards, outwards) > 0.0 ? outwards : reflect(inwards, farSide);
    vec3 through = lookedUp(outwards);

    vec3 mirror = reflect(-towardsEye, normal);
    float share = fresnel(0.02, max(dot(normal, towardsEye), 0.0));
    vec3 glint = sunLight() * sun * (6.0 * pow(max(dot(mirror, towardsSun.xyz), 0.0), 160.0) +
                                   1.2 * pow(max(dot(outwards, towardsSun.xyz), 0.0), 24.0));
    vec3 light = through * (1.0 - share) + toneMapped(share * mirroredLight(mirror, 0.05)) + glint;
    colour = vec4(min(light, 1.0), covered * opacity);
}
