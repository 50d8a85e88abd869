// For tests: (2 r + 1) x (2 r + 1) comparisons, each texel by itself and at its centre, where GL_LINEAR has nothing to weigh:
// what the lookups of shaders/shadow_map/filters/filter_pcf.glsl between texels stand for.
uniform sampler2DArrayShadow shadowMap;
uniform int pcfRadius;

float filteredVisibility(MapPlace place) {
    float lit = 0.0;
    for (int dy = -pcfRadius; dy <= pcfRadius; ++dy)
        for (int dx = -pcfRadius; dx <= pcfRadius; ++dx) {
            vec2 centre = (floor(place.uv * resolution) + vec2(dx, dy) + 0.5) / resolution;
            float answer = texture(shadowMap, vec4(centre, float(place.layer), referenceDepth(place, vec2(0.0))));
            lit += floor(answer + 0.5); // yes or no: the quotient may be a little beside the centre
        }
    float width = float(2 * pcfRadius + 1);
    return lit / (width * width);
}
