layout(location = 0) in vec3 nodePosition;
layout(location = 1) in vec3 nodeNormal;
layout(location = 2) in vec3 nodeAlbedo;
layout(location = 3) in vec3 nodeWater;
layout(location = 4) in vec2 nodeShape;
layout(location = 5) in vec2 nodeCloth;
out vec3 position;
out vec3 normal;
out vec3 albedo;
out float gloss;
out float dampness;
out float transmittance;
out float hollow;
out float value;
out vec2 cloth;

void main() {
    position = nodePosition;
    normal = nodeNormal;
    albedo = nodeAlbedo;
    gloss = nodeWater.x;
    dampness = nodeWater.y;
    transmittance = nodeWater.z;
    hollow = nodeShape.x;
    value = nodeShape.y;
    cloth = nodeCloth;
    gl_Position = clipFromWorld * vec4(nodePosition, 1.0);
}
