// One layer of cloth, where no solid hides it.
in float transmittance;
uniform sampler2D sceneDepth;
out vec4 passing;

void main() {
    if (gl_FragCoord.z > texelFetch(sceneDepth, ivec2(gl_FragCoord.xy), 0).r) discard;
    passing = vec4(transmittance);
}
