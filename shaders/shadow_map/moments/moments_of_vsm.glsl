// Depth and its square.
vec4 momentsOf(float z) { return vec4(z, z * z, 0.0, 0.0); }
