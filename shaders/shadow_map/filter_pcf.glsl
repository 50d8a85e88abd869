// Percentage-closer filtering: compare first, then average the answers; averaging depths would mean nothing.
// Reeves, Salesin and Cook, "Rendering Antialiased Shadows with Depth Maps", 1987. A plain square of texels here.
uniform int pcfRadius;

float filteredVisibility(MapPlace place) {
    vec2 texelUv = 1.0 / vec2(textureSize(shadowMap, 0).xy);
    float lit = 0.0;
    for (int dy = -pcfRadius; dy <= pcfRadius; ++dy)
        for (int dx = -pcfRadius; dx <= pcfRadius; ++dx)
            lit += texture(shadowMap, vec4(place.shadowUv.xy + vec2(dx, dy) * texelUv, float(place.layer), place.shadowUv.z));
    float width = float(2 * pcfRadius + 1);
    return lit / (width * width);
}
