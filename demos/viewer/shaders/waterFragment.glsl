// Looks up the finished picture at the end of the refracted ray, and attenuates it by the length of the path
// through the water.
in vec3 position;
flat in vec3 normal;
flat in vec3 centre;
flat in vec3 extents;
flat in float time;
out vec4 colour;

uniform sampler2D scene;

// More than clear water takes, so that a tank of half a metre shows it; 1/m.
const vec3 absorption = vec3(0.75, 0.30, 0.24);
const vec3 scattered = vec3(0.10, 0.17, 0.19);

// The surface is a sum of waves that run in all directions: their wave numbers, 1/m, and how fast their
// phases turn.
const int waveCount = 7;
const vec3 waves[waveCount] = vec3[](vec3(21.0, 11.0, 1.9), vec3(-17.0, 27.0, -2.3), vec3(36.0, -14.0, 2.6),
                                     vec3(9.0, 47.0, -2.9), vec3(-52.0, -19.0, 3.1), vec3(41.0, 49.0, 3.4),
                                     vec3(-33.0, 71.0, -3.7));
// All waves are equally steep.
const float steepness = 0.011;

float phase(int wave, vec2 at) {
    return dot(waves[wave].xy, at) + waves[wave].z * time + float(wave * wave);
}

vec2 slope(vec2 at) {
    vec2 sum = vec2(0.0);
    for (int i = 0; i < waveCount; ++i) {
        sum += normalize(waves[i].xy) * cos(phase(i, at));
    }
    return steepness * sum;
}

vec3 rippled() {
    // Half as steep as the waves of the caustics.
    vec2 rise = 0.5 * slope(position.xz);
    return normalize(vec3(-rise.x, 1.0, -rise.y));
}

// Distance along a ray from here until it leaves the water.
float wayThrough(vec3 direction) {
    vec3 steady = mix(vec3(1e-5), direction, greaterThan(abs(direction), vec3(1e-5)));
    vec3 ways = (sign(steady) * extents - (position - centre)) / steady;
    return max(min(ways.x, min(ways.y, ways.z)), 0.0);
}

ivec2 pixelOf(vec3 place) {
    vec4 clip = clipFromWorld * vec4(place, 1.0);
    vec2 size = vec2(textureSize(scene, 0));
    return ivec2(clamp((clip.xy / clip.w * 0.5 + 0.5) * size, vec2(0.0), size - 1.0));
}

bool inWater(vec3 place) {
    return all(lessThan(abs(place - centre), extents + 0.01));
}

// The first position along a path from here that is hidden, between one that is visible and one that is
// hidden, as fractions of the path.
float firstHidden(vec3 way, float from, float to) {
    for (int i = 0; i < 6; ++i) {
        float middle = 0.5 * (from + to);
        vec3 place = position + middle * way;
        bool hidden = distance(placeBehind(pixelOf(place)), eye.xyz) < distance(place, eye.xyz);
        from = hidden ? from : middle;
        to = hidden ? middle : to;
    }
    return to;
}

// Whether the camera sees a surface at a position, rather than one in front of it.
bool isSeen(vec3 place) {
    return distance(place, placeBehind(pixelOf(place))) < 0.03;
}

// The position where a ray into the water hits a surface that the camera sees, as a fraction of the ray; 1 if
// there is none.
float firstMet(vec3 way) {
    const int steps = 24;
    float thickness = 2.0 * length(way) / float(steps);
    for (int i = 1; i <= steps; ++i) {
        vec3 place = position + float(i) / float(steps) * way;
        vec3 seen = placeBehind(pixelOf(place));
        float behindIt = distance(place, eye.xyz) - distance(seen, eye.xyz);
        if (behindIt > 0.0 && behindIt < thickness && inWater(seen)) {
            float met = firstHidden(way, float(i - 1) / float(steps), float(i) / float(steps));
            if (isSeen(position + met * way)) return met;
        }
    }
    return 1.0;
}

// Light that the waves gather where they are hollow and spread where they are round, as a factor on that of
// the sun and the sky: where rays that came in side by side arrive, and how much closer they are then.
float caustics(vec3 place, float down) {
    // Waves in a tank are lower than those that throw lines as sharp as one knows them.
    float bend = 6.0 * 0.25 * down;
    vec2 below = place.xz + towardsSun.xz / max(towardsSun.y, 0.2) * 0.75 * down;
    vec2 at = below;
    for (int i = 0; i < 3; ++i) {
        at = below + bend * slope(at);
    }
    mat2 curvature = mat2(0.0);
    for (int i = 0; i < waveCount; ++i) {
        float along = -sin(phase(i, at)) / length(waves[i].xy);
        curvature += along * outerProduct(waves[i].xy, waves[i].xy);
    }
    float spread = abs(determinant(mat2(1.0) - bend * steepness * curvature));
    return mix(0.72, 1.0, min(1.0 / (0.25 + spread), 3.0));
}

// Whether a pixel shows an object in front of a position or of the water there.
bool hidesAlone(ivec2 pixel, vec3 place) {
    vec3 seen = placeBehind(pixel);
    bool beforeWater = dot(seen - position, normal) > 0.0;
    return beforeWater || (inWater(seen) && distance(seen, eye.xyz) < distance(place, eye.xyz) - 0.04);
}

// Also if such an object is only near the pixel, because its colour is then mixed into it.
bool hides(ivec2 pixel, vec3 place) {
    ivec2 last = textureSize(sceneDepth, 0) - 1;
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = pixel + 2 * ivec2(i & 1, i >> 1) - 1;
        if (hidesAlone(clamp(corner, ivec2(0), last), place)) return true;
    }
    return hidesAlone(pixel, place);
}

// The pixel of a position or, if it is hidden, the nearest one that is not: hidden areas look similar.
ivec2 clearPixelOf(vec3 place) {
    const ivec2 ways[4] = ivec2[](ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1));
    ivec2 pixel = pixelOf(place);
    if (!hides(pixel, place)) return pixel;
    ivec2 size = textureSize(scene, 0);
    int step = max(size.y / 120, 1);
    for (int i = 0; i < 16; ++i) {
        ivec2 other = clamp(pixel + (step << (i >> 2)) * ways[i & 3], ivec2(0), size - 1);
        if (!hides(other, place)) return other;
    }
    return pixel;
}

// Where water meets glass it climbs up a little and catches light: 1 there, 0 elsewhere, averaged over the
// pixel.
float meniscus() {
    const float width = 0.0025;
    vec2 fromGlass = max(extents.xz - abs(position.xz - centre.xz), 0.0);
    vec2 pixel = max(abs(dFdx(position.xz)), abs(dFdy(position.xz)));
    float blurred = width + max(pixel.x, pixel.y);
    return width / blurred * exp(-min(fromGlass.x, fromGlass.y) / blurred);
}

// The picture around a position, and in w the fraction of it that is also near in depth: less at an edge, and
// for thin objects.
vec4 mirroredRound(vec3 place) {
    ivec2 size = textureSize(scene, 0);
    ivec2 middle = pixelOf(place);
    int apart = max(size.y / 360, 1);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 9; ++i) {
        ivec2 pixel = clamp(middle + apart * (ivec2(i % 3, i / 3) - 1), ivec2(0), size - 1);
        vec3 seen = placeBehind(pixel);
        float known = step(distance(seen, place), 0.06);
        sum += known * vec4(texelFetch(scene, pixel, 0).rgb, 1.0);
    }
    return vec4(sum.rgb / max(sum.w, 1.0), smoothstep(0.3, 1.0, sum.w / 9.0));
}

// The reflection in the surface: solids and sheets where the picture shows them, otherwise sky and ground.
// Already tone mapped.
vec3 mirroredScene(vec3 direction, float roughness) {
    const int steps = 32;
    const float reach = 1.6;
    vec3 around = toneMapped(mirroredLight(direction, roughness));
    float nearer = 0.0;
    for (int i = 1; i <= steps; ++i) {
        float share = float(i) / float(steps);
        float far = reach * share * share;
        vec3 place = position + far * direction;
        vec4 clip = clipFromWorld * vec4(place, 1.0);
        vec2 edge = abs(clip.xy / clip.w);
        if (clip.w <= 0.0 || max(edge.x, edge.y) > 1.0) return around;
        vec3 seen = placeBehind(pixelOf(place));
        float behindIt = distance(place, eye.xyz) - distance(seen, eye.xyz);
        // Nothing on the far side of the surface is mirrored by it.
        bool before = dot(seen - position, normal) > 0.0;
        if (before && behindIt > 0.0 && behindIt < 0.02 + 1.5 * (far - nearer)) {
            vec3 met = position + firstHidden(direction, nearer, far) * direction;
            if (isSeen(met)) {
                vec4 found = mirroredRound(met);
                vec2 kept = smoothstep(1.0, 0.85, edge);
                return mix(around, found.rgb, found.w * kept.x * kept.y);
            }
        }
        nearer = far;
    }
    return around;
}

void main() {
    vec3 towardsEye = normalize(eye.xyz - position);
    if (dot(normal, towardsEye) <= 0.0) discard;
    bool onTop = normal.y > 0.5;
    vec3 facing = onTop ? rippled() : normal;
    vec3 into = refract(-towardsEye, facing, 1.0 / 1.33);
    vec3 way = wayThrough(into) * into;
    vec3 met = position + firstMet(way) * way;
    ivec2 pixel = clearPixelOf(met);
    vec3 below = texelFetch(scene, pixel, 0).rgb;
    // Light came down through the water before it came up.
    float down = clamp(centre.y + extents.y - met.y, 0.0, 2.0 * extents.y);
    vec3 kept = exp(-absorption * (distance(met, position) + down));
    if (inWater(placeBehind(pixel))) below *= mix(1.0, caustics(met, down), smoothstep(0.0, 0.1, down));
    below = below * kept + scattered * (1.0 - kept);

    Surface s;
    s.position = position;
    s.normal = facing;
    s.reflectance = onTop ? 0.02 : 0.04;
    s.roughness = 0.12;
    float facingEye = max(dot(facing, towardsEye), 0.02);
    float facingSun = max(dot(facing, towardsSun.xyz), 0.0);
    vec3 mirrored = mirroredScene(reflect(-towardsEye, facing), s.roughness);
    vec3 glint =
        sunLight() * sunVisible(position, normal) * facingSun * sunGlint(s, towardsEye, facingSun, facingEye);
    float share = fresnel(s.reflectance, facingEye);
    if (onTop) share = mix(share, 0.75, meniscus());
    colour = vec4(below * (1.0 - share) + share * mirrored + toneMapped(glint), 1.0);
}
