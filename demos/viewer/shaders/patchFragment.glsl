// Looks up the position of the solid in this pixel, and how wet the patch makes it.
flat in vec4 ball;
flat in vec4 turn;
flat in vec2 kind;
out vec4 colour;

void main() {
    vec4 back = vec4(-turn.xyz, turn.w);
    vec3 within = turned(placeBehind(ivec2(gl_FragCoord.xy)) - ball.xyz, back) / ball.w;
    vec3 shape = within + 61.0 * kind.y;
    float uneven = 0.75 * valueNoise(1.9 * shape) + 0.40 * valueNoise(4.6 * shape);
    uneven += 0.15 * valueNoise(12.0 * shape);
    float outwards = length(within) * max(1.12 + uneven, 0.8);
    float wet = kind.x * (1.0 - smoothstep(0.45, 1.03, outwards));
    colour = vec4(wet);
}
