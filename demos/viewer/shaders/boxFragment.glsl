// As on a ball, cloth that lies on the box must be drawn over it; here per pixel, because corners are far
// apart.
in vec3 position;
in vec3 inBox;
flat in vec3 normal;
flat in vec3 extents;
flat in vec3 albedo;
flat in int material;
out vec4 colour;

// The edges of the box from the longest to the shortest, as x, y and z.
vec3 byLength(vec3 at, vec3 sides) {
    at = sides.x >= sides.y && sides.x >= sides.z ? at.xyz : sides.y >= sides.z ? at.yzx : at.zxy;
    sides = sides.x >= sides.y && sides.x >= sides.z ? sides.xyz : sides.y >= sides.z ? sides.yzx : sides.zxy;
    return sides.y >= sides.z ? at : at.xzy;
}

// A wide box is made of boards. Moves `at` into a separate piece of wood for each board, and returns its
// brightness and the fraction of the pixel that is a joint.
void findBoard(inout vec3 at, vec3 sides, out float lightness, out float joint) {
    const float widest = 0.14, halfJoint = 0.0022;
    float side = byLength(sides, sides).y;
    float count = ceil(2.0 * side / widest);
    float width = 2.0 * side / count;
    float board = clamp(floor((at.y + side) / width), 0.0, count - 1.0);
    float within = at.y + side - board * width;
    float pixel = max(fwidth(at.y), 1e-5);
    float covered = clamp((halfJoint + 0.5 * pixel - min(within, width - within)) / pixel, 0.0, 1.0);
    joint = count > 1.5 ? covered * min(2.0 * halfJoint / pixel, 1.0) : 0.0;
    lightness = 1.0 + 0.25 * latticeValue(vec2(board, 7.0));
    float shift = 0.06 * latticeValue(vec2(board, 3.0));
    at = vec3(at.x + 1.7 * board, within - 0.5 * width + shift, at.z + 0.03 * board);
}

void main() {
    vec3 at = byLength(inBox, extents);
    vec3 albedoHere = albedo;
    if (material == wood) {
        float lightness, joint;
        findBoard(at, extents, lightness, joint);
        albedoHere *= lightness * (1.0 - 0.75 * joint);
    }
    Finish finish = finishOf(material, at, albedoHere, min(extents.x, min(extents.y, extents.z)));
    float openness = opennessAboveGround(position, normal);
    colour = vec4(toneMapped(shadedSolid(material, finish, position, normal, openness)), 1.0);
    vec4 behind = clipFromWorld * vec4(position + 0.003 * normalize(position - eye.xyz), 1.0);
    gl_FragDepth = 0.5 + 0.5 * behind.z / behind.w;
}
