// The same step toward the light everywhere. Enough for surfaces that face the light, too little where it grazes them, and
// too much for whatever touches what it stands on. Williams 1978.
uniform float constantTexels; // how far, in texels, or
uniform float constantMetres;

vec3 pointToAsk(vec3 pointLightRelative, int layer) {
    float metres = constantMetres + constantTexels * texelMetres(pointLightRelative, layer);
    return pointLightRelative + metres * towardLightFrom(pointLightRelative);
}
float depthToCompare(MapPlace place, vec2 offsetUv) { return place.depth; }
