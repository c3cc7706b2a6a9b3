// The length of the line of sight within the cloud, in front of solids.
in vec2 onPuff;
in vec3 position;
flat in vec4 ball;
flat in float thickness;
flat in float sun;
out vec4 colour;

void main() {
    float inside = 1.0 - dot(onPuff, onPuff);
    if (inside <= 0.0) discard;
    vec3 solid = placeBehind(ivec2(gl_FragCoord.xy));
    float beforeSolid = distance(solid, eye.xyz) - distance(position, eye.xyz);
    float reach = ball.w * sqrt(inside);
    float open = clamp(0.5 + 0.5 * beforeSolid / max(reach, 1e-5), 0.0, 1.0);
    // Clouds are uneven, and fade out at their rims.
    float uneven = 1.0 + 1.2 * valueNoise(11.0 * position) + 0.7 * valueNoise(27.0 * position);
    float optical = -log(1.0 - min(thickness, 0.98)) * inside * inside * max(uneven, 0.0) * open;

    vec3 away = normalize(position - eye.xyz);
    float intoSun = dot(away, towardsSun.xyz);
    // Henyey and Greenstein's phase function of droplets that scatter forwards, 1 on average.
    const float g = 0.6;
    float phase = (1.0 - g * g) / pow(1.0 + g * g - 2.0 * g * intoSun, 1.5);
    vec3 light = 0.85 * ambientLight(vec3(0.0, 1.0, 0.0)) + 0.35 * phase * sun * sunLight();
    colour = vec4(toneMapped(light), 1.0 - exp(-optical));
}
