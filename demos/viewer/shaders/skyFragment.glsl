in vec2 screen;
out vec4 colour;

// Thin uneven cloud on a level sheet high up.
float clouds(vec3 direction) {
    vec2 at = direction.xz / (max(direction.y, 0.0) + 0.25) * 1.7;
    return valueNoise(at) + 0.5 * valueNoise(2.1 * at + 7.3) + 0.25 * valueNoise(4.3 * at + 2.9);
}

void main() {
    vec4 ray = offsetFromClip * vec4(screen, 1.0, 1.0);
    vec3 direction = normalize(ray.xyz / ray.w);
    float clear = smoothstep(0.0, 0.35, direction.y);
    vec3 light = skyLight(direction) * (1.0 + 0.16 * clear * clouds(direction));
    colour = vec4(toneMapped(light), 1.0);
}
