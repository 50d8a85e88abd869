// Points spread evenly over a disc or a square, turned by chance.
uniform int noise; // 0 once for each texel, 1 for each pixel, 2 never

const float kGoldenAngle = 2.39996323; // of a sunflower: no two seeds in one direction

// Two numbers in 0..1 that look random, and are always the same for the same three. Jarzynski and Olano, "Hash Functions for
// GPU Rendering", Journal of Computer Graphics Techniques 9(3), 2020: pcg3d.
vec2 hash(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v += v.yzx * v.zxy;
    v ^= v >> 16u;
    v += v.yzx * v.zxy;
    return vec2(v.xy >> 8u) / 16777216.0;
}

// Noise that belongs to a texel stays where it is on the surface when the eye moves.
vec2 noiseAt(MapPlace place) {
    if (noise == 2) return vec2(0.0);
    ivec2 seed = noise == 1 ? ivec2(gl_FragCoord.xy) : ivec2(floor(place.uv * resolution));
    return hash(uvec3(uvec2(seed), uint(place.layer)));
}

// Of `count` points within the unit circle, the seeds of a sunflower. Vogel, "A Better Way to Construct the Sunflower Head",
// Mathematical Biosciences 44, 1979.
vec2 pointInDisc(int i, int count, vec2 chance) {
    float angle = float(i) * kGoldenAngle + 6.2831853 * chance.x;
    return sqrt((float(i) + 0.5) / float(count)) * vec2(cos(angle), sin(angle));
}

// Of any number of points in the square from -1 to 1, evenly spread. Roberts, "The Unreasonable Effectiveness of
// Quasirandom Sequences", 2018: multiples of the powers of the plastic number's inverse.
vec2 pointInSquare(int i, vec2 chance) {
    return 2.0 * fract(chance + float(i + 1) * vec2(0.7548776662, 0.5698402910)) - 1.0;
}
