// Percentage-closer filtering: compare first, then average the answers; averaging depths would mean nothing.
// Reeves, Salesin and Cook, "Rendering Antialiased Shadows with Depth Maps", 1987. A plain square of texels here.
uniform sampler2DArrayShadow shadowMap;
uniform int pcfRadius;

#ifdef ONE_DEPTH
// Where all texels are compared with one depth, a lookup with GL_LINEAR right between four of them is the mean of four
// comparisons; between two, of two. So (r + 1) x (r + 1) lookups do for (2 r + 1) x (2 r + 1) texels: pairs of columns
// and rows, and a single one at the end. The counts are whole, and rounding makes them exactly so.
// After Sigg and Hadwiger, "Fast Third-Order Texture Filtering", GPU Gems 2, 2005.
// [anchor: compare-pcf-pairs]
float filteredVisibility(MapPlace place) {
    float depth = referenceDepth(place, vec2(0.0)), lit = 0.0;
    vec2 firstTexel = floor(place.uv * resolution) - float(pcfRadius); // of the square, at its lower left
    for (int row = 0; row <= pcfRadius; ++row)
        for (int column = 0; column <= pcfRadius; ++column) {
            vec2 texels = vec2(column == pcfRadius ? 1.0 : 2.0, row == pcfRadius ? 1.0 : 2.0);
            vec2 between = (firstTexel + 2.0 * vec2(column, row) + 0.5 * texels) / resolution;
            lit += floor(texture(shadowMap, vec4(between, float(place.layer), depth)) * texels.x * texels.y + 0.5);
        }
    float width = float(2 * pcfRadius + 1);
    return lit / (width * width);
}
#else
// Each texel is compared with the depth of the receiver's plane over there, so each needs a lookup of its own.
// [anchor: compare-pcf]
float filteredVisibility(MapPlace place) {
    float lit = 0.0;
    for (int dy = -pcfRadius; dy <= pcfRadius; ++dy)
        for (int dx = -pcfRadius; dx <= pcfRadius; ++dx) {
            vec2 offsetUv = vec2(dx, dy) / resolution;
            lit += texture(shadowMap, vec4(place.uv + offsetUv, float(place.layer), referenceDepth(place, offsetUv)));
        }
    float width = float(2 * pcfRadius + 1);
    return lit / (width * width);
}
#endif
