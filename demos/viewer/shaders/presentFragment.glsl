// Linear light to sRGB bytes, with half a step of dither so that the sky has no bands.
in vec2 screen;
uniform sampler2D scene;
out vec4 colour;

vec3 encoded(vec3 light) {
    vec3 low = 12.92 * light;
    vec3 high = 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055;
    return mix(low, high, step(vec3(0.0031308), light));
}

void main() {
    vec3 light = clamp(texelFetch(scene, ivec2((0.5 * screen + 0.5) * vec2(textureSize(scene, 0))), 0).rgb, 0.0, 1.0);
    float dither = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
    colour = vec4(encoded(light) + dither / 255.0, 1.0);
}
