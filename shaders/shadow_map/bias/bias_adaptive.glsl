// The map was asked along the ray through a texel's centre: so where does that ray meet the receiver's plane? Compare with
// the depth there. What remains is rounding. Dou, Yan, Kerzner, Dai and Wyman, "Adaptive Depth Bias for Shadow Maps",
// Journal of Computer Graphics Techniques 3(4), 2014.
#define COMPARES_AT_CENTRES // of texels, and not at the point itself

vec4 biasedClip(vec4 lightClip, int layer) { return lightClip; }

float depthToCompare(MapPlace place, vec2 offsetUv) {
    vec2 centreUv = (floor((place.uv + offsetUv) * resolution) + 0.5) / resolution;
    return place.depth + dot(place.slope, centreUv - place.uv);
}
