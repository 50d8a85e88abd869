// Of a number with that mean and mean square, at most which share can be at or beyond `x`? Chebyshev's inequality, one-sided
// (Cantelli). No bound where x is before the mean.
float largestShareBeyond(float x, vec2 moments, float leastVariance) {
    if (x <= moments.x) return 1.0;
    float variance = max(moments.y - moments.x * moments.x, leastVariance);
    float beyond = x - moments.x;
    return variance / (variance + beyond * beyond);
}

// Light that bleeds through is never as bright as light: what is no more lit than `least` is dark. Lauritzen, GPU Gems 3, 2007.
uniform float bleedReduction;
float withoutBleeding(float visibility) { return clamp((visibility - bleedReduction) / (1.0 - bleedReduction), 0.0, 1.0); }
