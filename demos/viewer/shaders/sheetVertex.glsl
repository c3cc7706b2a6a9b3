layout(location = 0) in vec3 vertexPosition;
layout(location = 1) in vec4 normalAndHollow;
layout(location = 2) in vec4 albedoAndValue;
layout(location = 3) in vec2 clothCoordinates;
layout(location = 4) in vec3 water;
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
    position = vertexPosition;
    normal = normalAndHollow.xyz;
    hollow = normalAndHollow.w;
    albedo = albedoAndValue.xyz;
    value = albedoAndValue.w;
    cloth = clothCoordinates;
    gloss = water.x;
    dampness = water.y;
    transmittance = water.z;
    gl_Position = clipFromWorld * vec4(vertexPosition, 1.0);
}
