// Fractions of the sun (sunVisible) and of the sky (openness) that reach a point.
uniform sampler2DShadow sunShadow;
// The same map without the comparison.
uniform sampler2D sunDepth;
// Fraction of the sunlight that sheets transmit, and the depth of the nearest solid.
uniform sampler2D sunPassing;

// A dither angle for each pixel that turns the sampling pattern, so that bands become fine grain.
float pixelAngle() {
    return 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
}

vec2 pattern(int tap, int taps, float start) {
    const float goldenAngle = 2.3999632;
    float angle = start + goldenAngle * float(tap);
    return sqrt((float(tap) + 0.5) / float(taps)) * vec2(cos(angle), sin(angle));
}

// Radius over which shadow edges are blurred, m: increases with the distance from the object that casts the
// shadow. 0 if there is none near `map`.
float penumbra(vec3 map, float start) {
    const int taps = 10;
    const float search = 0.11;
    // The half angle under which the hazy sun appears, a good deal wider than the bare one.
    const float sunHalfAngle = 0.045;
    float blockers = 0.0;
    float depths = 0.0;
    for (int i = 0; i < taps; ++i) {
        // Closer together in the middle, so that what is thin is not missed.
        float reach = search * sqrt((float(i) + 0.5) / float(taps));
        float depth = texture(sunDepth, map.xy + reach / shadowSize.x * pattern(i, taps, start)).r;
        float blocks = step(depth, min(map.z, 0.99999));
        blockers += blocks;
        depths += blocks * depth;
    }
    if (blockers == 0.0) return 0.0;
    float gap = (map.z - depths / blockers) * shadowSize.z;
    return clamp(sunHalfAngle * gap, max(0.008, 1.5 * shadowSize.y), search);
}

float sunVisible(vec3 position, vec3 normal) {
    const int taps = 20;
    // Moves the point off its own surface, to the side that the sun is on.
    float facing = dot(normal, towardsSun.xyz);
    vec3 outwards = facing < 0.0 ? -normal : normal;
    float slope = sqrt(max(1.0 - facing * facing, 0.0));
    vec3 lifted = position + outwards * (0.003 + 0.012 * slope + 1.5 * shadowSize.y);
    vec3 map = (shadowFromWorld * vec4(lifted, 1.0)).xyz * 0.5 + 0.5;
    if (any(lessThan(map.xy, vec2(0.0))) || any(greaterThan(map.xy, vec2(1.0)))) return 1.0;
    float start = pixelAngle();
    float radius = penumbra(map, start) / shadowSize.x;
    if (radius == 0.0) return 1.0;
    // Ground beyond the far plane of the map is still behind everything that casts a shadow.
    float depth = min(map.z, 0.99999);
    float visible = 0.0;
    vec2 throughSheets = vec2(0.0, 1e-4);
    for (int i = 0; i < taps; ++i) {
        vec2 at = map.xy + radius * pattern(i, taps, start);
        float lit = texture(sunShadow, vec3(at, depth));
        visible += lit;
        if (i % 2 == 0) {
            vec2 passing = texture(sunPassing, at).xy;
            // Without a sheet there, the shadow is that of a solid.
            passing.x *= step(passing.x, 0.999) * step(depth, passing.y + 0.0005);
            throughSheets += (1.0 - lit) * vec2(passing.x, 1.0);
        }
    }
    visible /= float(taps);
    return visible + (1.0 - visible) * throughSheets.x / throughSheets.y;
}

// The fraction of the sky that is not hidden by balls, seen from a surface facing `normal`.
float opennessAmongBalls(vec3 position, vec3 normal) {
    float open = 1.0;
    for (int i = 0; i < int(ground.y); ++i) {
        vec3 towards = balls[i].xyz - position;
        float distance2 = dot(towards, towards);
        float radius2 = balls[i].w * balls[i].w;
        // Close to a ball the formula for a far one would cover more than all of the sky.
        float covered = radius2 / max(distance2, radius2);
        float facing = clamp(0.5 + 0.5 * dot(normal, towards) * inversesqrt(max(distance2, 1e-8)), 0.0, 1.0);
        open *= 1.0 - 0.9 * covered * facing * facing;
    }
    return open;
}

float opennessAboveGround(vec3 position, vec3 normal) {
    float height = max(position.y - ground.x, 0.0);
    return 1.0 - 0.35 * exp(-height / 0.15) * (0.5 - 0.5 * normal.y);
}
