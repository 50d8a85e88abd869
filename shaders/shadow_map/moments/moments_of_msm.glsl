// Powers of depth, z from -1 to 1.
vec4 momentsOf(float z) { return vec4(z, z * z, z * z * z, z * z * z * z); }
