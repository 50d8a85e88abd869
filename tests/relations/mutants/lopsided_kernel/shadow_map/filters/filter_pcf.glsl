// For tests: a kernel that lies to one side of the texel instead of around it. Every shadow looks right, and is shifted.
uniform sampler2DArrayShadow shadowMap;
uniform int pcfRadius;

float filteredVisibility(MapPlace place) {
    float lit = 0.0;
    for (int dy = 0; dy <= 2 * pcfRadius; ++dy)
        for (int dx = 0; dx <= 2 * pcfRadius; ++dx) {
            vec2 offsetUv = vec2(dx, dy) / resolution;
            lit += texture(shadowMap, vec4(place.uv + offsetUv, float(place.layer), referenceDepth(place, offsetUv)));
        }
    float width = float(2 * pcfRadius + 1);
    return lit / (width * width);
}
