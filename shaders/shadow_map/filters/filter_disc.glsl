// Percentage-closer filtering with points in a disc instead of a square: fewer comparisons for the same width, and noise where
// the square has steps. The disc is turned by chance, so that neighbours do not share their errors. Reeves, Salesin and Cook,
// 1987, chose points by chance as well; the sunflower is Vogel's, 1979 (sample_points.glsl).
uniform sampler2DArrayShadow shadowMap;
uniform int samples;
uniform float discRadius; // texels
#include "shadow_map/sample_points.glsl"

// [anchor: compare-disc]
float filteredVisibility(MapPlace place) {
    vec2 chance = noiseAt(place);
    float lit = 0.0;
    for (int i = 0; i < samples; ++i) {
        vec2 offsetUv = discRadius / resolution * pointInDisc(i, samples, chance);
        lit += texture(shadowMap, vec4(place.uv + offsetUv, float(place.layer), referenceDepth(place, offsetUv)));
    }
    return lit / float(samples);
}
