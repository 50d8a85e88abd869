// Variance shadow maps: of the depths in a neighbourhood keep the mean and the mean square, which may be averaged and
// interpolated like any picture. They tell at most which share of those depths is at or beyond the receiver. Exact for one
// surface before a parallel one; where three lie behind each other light bleeds through. Donnelly and Lauritzen, "Variance
// Shadow Maps", I3D 2006.
#include "shadow_map/moments/moments.glsl"
#include "shadow_map/moments/chebyshev.glsl"
uniform float leastDeviation; // of depths from -1 to 1

// [anchor: compare-vsm]
float filteredVisibility(MapPlace place) {
    if (isOutside(place)) return 1.0;
    float share = largestShareBeyond(receiverMomentDepth(place), momentsAt(place).xy, leastDeviation * leastDeviation);
    return withoutBleeding(share);
}
