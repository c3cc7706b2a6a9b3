// The uniform block of frame_uniforms.h.
layout(std140) uniform Frame {
    mat4 clipFromWorld;
    mat4 offsetFromClip;
    mat4 shadowFromWorld;
    vec4 eye;
    vec4 towardsSun;
    vec4 shadowSize;
    vec4 ground;
    vec4 balls[8];
    vec4 lens;
    vec4 patched;
};
