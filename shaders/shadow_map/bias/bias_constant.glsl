// The same step toward the light everywhere. Enough for surfaces that face the light, too little where it grazes them, and
// too much for whatever touches what it stands on. Williams 1978.
uniform float constantTexels; // how far, in texels, or
uniform float constantMetres;

vec4 biasedClip(vec4 lightClip, int layer) {
    float metres = constantMetres + constantTexels * texelMetres(lightClip, layer);
    return lightClip + lightClipFromLightRelative[layer] * vec4(metres * towardLightFrom(positionLightRelative), 0.0);
}
float depthToCompare(MapPlace place, vec2 offsetUv) { return place.depth; }
