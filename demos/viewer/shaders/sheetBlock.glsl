// The uniform block of sheet_uniforms.h.
layout(std140) uniform Sheet {
    vec4 clothBounds;
    vec4 threading;
    vec4 legend;
    vec4 legendColours[9];
};
