// Mixes three nodes of a sheet into a vertex of its rounded surface. Nodes and vertices have the layout of
// SheetVertex.
layout(location = 0) in uvec3 corners;
layout(location = 1) in vec3 weights;
uniform samplerBuffer sheetNodes;
out vec4 positionAndRoundness;
out vec4 normalAndHollow;
out vec4 albedoAndValue;
out vec4 clothAndWater;
out vec4 moreWater;

vec4 ofNode(uint node, int part) {
    return texelFetch(sheetNodes, 5 * int(node) + part);
}

vec4 mixed(int part) {
    return weights.x * ofNode(corners.x, part) + weights.y * ofNode(corners.y, part) +
           weights.z * ofNode(corners.z, part);
}

// From a point of the flat triangle towards the tangent plane at a corner.
vec3 lift(uint corner, float weight, vec3 point) {
    vec4 place = ofNode(corner, 0);
    vec3 upright = ofNode(corner, 1).xyz;
    return weight * place.w * dot(upright, place.xyz - point) * upright;
}

void main() {
    positionAndRoundness = mixed(0);
    normalAndHollow = mixed(1);
    albedoAndValue = mixed(2);
    clothAndWater = mixed(3);
    moreWater = mixed(4);
    // The sphere with these normals lies halfway between the flat triangle and the tangent planes at its corners.
    vec3 point = positionAndRoundness.xyz;
    positionAndRoundness.xyz += 0.5 * (lift(corners.x, weights.x, point) + lift(corners.y, weights.y, point) +
                                       lift(corners.z, weights.z, point));
}
