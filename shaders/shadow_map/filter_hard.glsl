// One comparison with the nearest texel. Williams, "Casting Curved Shadows on Curved Surfaces", 1978.
float filteredVisibility(MapPlace place) {
    return texture(shadowMap, vec4(place.shadowUv.xy, float(place.layer), place.shadowUv.z));
}
