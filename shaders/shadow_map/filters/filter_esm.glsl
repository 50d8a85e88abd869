// Exponential shadow maps: with d the receiver's depth and z a texel's, exp(-c (d - z)) is nearly the step that a comparison
// is, and a product, so that exp(c z) can be averaged before d is known. Too bright close behind what casts the shadow; exp
// overflows at 88.7 in 32 bits and at 11.1 in 16. Annen, Mertens, Seidel, Flerackers and Kautz, "Exponential Shadow Maps",
// Graphics Interface 2008; averages of logarithms: Lauritzen and McCool, "Layered Variance Shadow Maps", same conference.
#include "shadow_map/moments/moments.glsl"
uniform float esmExponent;
uniform int logarithms;

// log(mean of exp(v)) over the four texels around, weighted by how near they are, without ever forming exp(v).
float meanOfFour(MapPlace place) {
    vec2 texel = place.uv * resolution - 0.5;
    ivec2 lower = ivec2(floor(texel)), last = ivec2(resolution) - 1;
    vec2 share = texel - floor(texel);
    vec4 v, weights = vec4((1.0 - share.x) * (1.0 - share.y), share.x * (1.0 - share.y), (1.0 - share.x) * share.y, share.x * share.y);
    for (int i = 0; i < 4; ++i)
        v[i] = texelFetch(moments, ivec3(clamp(lower + ivec2(i & 1, i >> 1), ivec2(0), last), place.layer), 0).r;
    float largest = max(max(v.x, v.y), max(v.z, v.w));
    return largest + log(dot(weights, exp(v - largest)));
}

// [anchor: compare-esm]
float filteredVisibility(MapPlace place) {
    if (isOutside(place)) return 1.0;
    float exponent = esmExponent * (0.5 * receiverMomentDepth(place) + 0.5);
    if (logarithms == 1) return min(exp(meanOfFour(place) - exponent), 1.0);
    return clamp(momentsAt(place).r * exp(-exponent), 0.0, 1.0);
}
