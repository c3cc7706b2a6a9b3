// Sunlight at a small object in the air, with a single lookup for all of its pixels.
uniform sampler2DShadow sunShadow;

float sunAt(vec3 place) {
    vec3 map = (shadowFromWorld * vec4(place, 1.0)).xyz * 0.5 + 0.5;
    bool outside = any(lessThan(map.xy, vec2(0.0))) || any(greaterThan(map.xy, vec2(1.0)));
    return outside ? 1.0 : textureLod(sunShadow, vec3(map.xy, min(map.z, 0.99999)), 0.0);
}
