// A quad perpendicular to the line of sight, as long as the drop moves during the exposure.
layout(location = 0) in vec4 centreAndRadius;
layout(location = 1) in vec4 drawnOut;
out vec2 onDrop;
flat out vec3 centre;
flat out vec3 along;
flat out vec3 across;
flat out vec3 towardsEye;
flat out float opacity;
flat out float sun;
flat out float slimness;

void main() {
    centre = centreAndRadius.xyz;
    towardsEye = normalize(eye.xyz - centre);
    sun = sunAt(centre);
    float smallest = 0.75 * metresPerPixel(centre);
    float radius = max(centreAndRadius.w, smallest);
    // A drop smaller than a pixel covers a fraction of it.
    opacity = pow(centreAndRadius.w / radius, 1.5);
    vec3 seen = drawnOut.xyz - dot(drawnOut.xyz, towardsEye) * towardsEye;
    float halfWay = 0.5 * length(seen);
    vec3 helper = abs(towardsEye.y) < 0.95 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    helper = normalize(helper - dot(helper, towardsEye) * towardsEye);
    along = halfWay > 1e-6 ? 0.5 * seen / halfWay : helper;
    across = cross(along, towardsEye);
    float halfLength = radius + halfWay;
    slimness = radius / halfLength;
    // It is at each position for a fraction of the exposure only.
    opacity *= mix(0.6, 1.0, slimness);
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    // Leaves room for a smooth edge.
    onDrop = corner * (1.0 + vec2(smallest / radius, smallest / halfLength));
    vec3 place = centre + onDrop.x * radius * across + onDrop.y * halfLength * along;
    gl_Position = clipFromWorld * vec4(place, 1.0);
}
