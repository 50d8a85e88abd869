// exp(c z), z from 0 to 1: or its logarithm, which cannot overflow.
uniform float esmExponent;
uniform int logarithms;
vec4 momentsOf(float z) {
    float exponent = esmExponent * (0.5 * z + 0.5);
    return vec4(logarithms == 1 ? exponent : exp(exponent), 0.0, 0.0, 0.0);
}
