// exp(c z) and its square; -exp(-c z) and its square.
uniform vec2 evsmExponents; // of the positive one, and of the negative one
vec4 momentsOf(float z) {
    float positive = exp(evsmExponents.x * z), negative = -exp(-evsmExponents.y * z);
    return vec4(positive, positive * positive, negative, negative * negative);
}
