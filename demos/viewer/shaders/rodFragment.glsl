in vec3 position;
in vec3 normal;
in vec3 onRod;
flat in float radius;
flat in vec3 albedo;
flat in int material;
out vec4 colour;

void main() {
    vec3 smoothNormal = normalize(normal);
    Finish finish = finishOf(material, onRod, albedo, radius);
    float openness = opennessAboveGround(position, smoothNormal);
    colour = vec4(toneMapped(shadedSolid(material, finish, position, smoothNormal, openness)), 1.0);
}
