// Exponential variance shadow maps: the variance of exp(c z) instead of z. The exponential draws what is far from the light
// apart and what is near together, so that three surfaces look nearly like two; -exp(-c z) does it the other way round, and the
// smaller of both bounds holds. The squares overflow at c = 44.4 in 32 bits and at 5.5 in 16. Lauritzen and McCool,
// "Layered Variance Shadow Maps", Graphics Interface 2008.
#include "shadow_map/moments/moments.glsl"
#include "shadow_map/moments/chebyshev.glsl"
uniform vec2 evsmExponents;
uniform int evsmMoments;
uniform float leastDeviation; // of depths from -1 to 1

// [anchor: compare-evsm]
float filteredVisibility(MapPlace place) {
    if (isOutside(place)) return 1.0;
    float z = receiverMomentDepth(place);
    vec4 m = momentsAt(place);
    // Of z a deviation s is one of s times the derivative.
    float positive = exp(evsmExponents.x * z), positiveDeviation = leastDeviation * evsmExponents.x * positive;
    float share = largestShareBeyond(positive, m.xy, positiveDeviation * positiveDeviation);
    if (evsmMoments == 4) {
        float negative = -exp(-evsmExponents.y * z), negativeDeviation = leastDeviation * evsmExponents.y * negative;
        share = min(share, largestShareBeyond(negative, m.zw, negativeDeviation * negativeDeviation));
    }
    return withoutBleeding(share);
}
