// Percentage-closer filtering: compare first, then average the answers; averaging depths would mean nothing.
// Reeves, Salesin and Cook, "Rendering Antialiased Shadows with Depth Maps", 1987. A plain square of texels here.
uniform int pcfRadius;

float filteredVisibility(MapPlace place) {
    vec2 texelUv = 1.0 / vec2(textureSize(shadowMap, 0).xy);
    float lit = 0.0;
    for (int dy = -pcfRadius; dy <= pcfRadius; ++dy)
        for (int dx = -pcfRadius; dx <= pcfRadius; ++dx) {
            // Each comparison uses the depth of the receiver's plane over there, never one behind the point itself: beyond
            // its edge the surface does not go on.
            vec2 offsetUv = vec2(dx, dy) * texelUv;
            float toward = halfTexel > 0.0 ? min(dot(place.slope, offsetUv), 0.0) : 0.0;
            lit += texture(shadowMap, vec4(place.shadowUv.xy + offsetUv, float(place.layer), place.shadowUv.z + toward));
        }
    float width = float(2 * pcfRadius + 1);
    return lit / (width * width);
}
