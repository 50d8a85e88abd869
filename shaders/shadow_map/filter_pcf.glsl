// Percentage-closer filtering: compare first, then average the answers; averaging depths would mean nothing.
// Reeves, Salesin and Cook, "Rendering Antialiased Shadows with Depth Maps", 1987. A plain square of texels here.
uniform int pcfRadius;

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
