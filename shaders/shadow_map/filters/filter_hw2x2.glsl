// The four texels around the point, compared and then weighted by how near they are: what graphics cards do in one lookup
// when a map that compares is sampled with GL_LINEAR. Reeves, Salesin and Cook, "Rendering Antialiased Shadows with Depth
// Maps", 1987, is the idea; the weights make the edge of a shadow a ramp one texel wide, without steps.
uniform sampler2DArrayShadow shadowMap;

// [anchor: compare-hw2x2]
float filteredVisibility(MapPlace place) {
    // All four are compared with one depth: the least of those that they should be compared with.
    vec2 toCentre = (floor(place.uv * resolution - 0.5) + 0.5) / resolution - place.uv; // of the lower left one
    float step = 1.0 / resolution;
    float depth = min(min(referenceDepth(place, toCentre), referenceDepth(place, toCentre + vec2(step, 0.0))),
                      min(referenceDepth(place, toCentre + vec2(0.0, step)), referenceDepth(place, toCentre + step)));
    return texture(shadowMap, vec4(place.uv, float(place.layer), depth));
}
