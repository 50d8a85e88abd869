// One comparison with the nearest texel. Williams, "Casting Curved Shadows on Curved Surfaces", 1978.
uniform sampler2DArrayShadow shadowMap;

// [anchor: compare-hard]
float filteredVisibility(MapPlace place) {
    return texture(shadowMap, vec4(place.uv, float(place.layer), referenceDepth(place, vec2(0.0))));
}
