// A vector turned by a quaternion of unit length.
vec3 turned(vec3 vector, vec4 turn) {
    return vector + 2.0 * cross(turn.xyz, cross(turn.xyz, vector) + turn.w * vector);
}
