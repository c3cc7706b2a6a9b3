// Drops of rain show a picture of most of the sky, wherever they are: pale against what is dark, dark against
// the sky.
in vec2 onStreak;
flat in float opacity;
flat in vec3 middle;
out vec4 colour;

void main() {
    vec3 away = normalize(middle - eye.xyz);
    float intoSun = max(dot(away, towardsSun.xyz), 0.0);
    vec3 sky = 0.62 * mix(horizonLight, zenithLight, 0.4) + 0.5 * sunLight() * pow(intoSun, 8.0);
    float across = exp(-4.0 * onStreak.x * onStreak.x);
    float ends = 1.0 - onStreak.y * onStreak.y;
    colour = vec4(toneMapped(sky), opacity * across * ends);
}
