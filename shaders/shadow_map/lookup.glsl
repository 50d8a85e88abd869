// From a point relative to the light to its place in the shadow map: lecture 2's (u, v) and z.
in vec3 positionLightRelative;
uniform mat4 lightClipFromLightRelative[6];
uniform int mapLayers;
uniform float pullShare;        // share of the distance, and
uniform vec3 pullLightRelative; // offset, by which a point is moved toward the light against rounding

// Of the six maps around a light, the one that looks along the largest component.
int mapLayer(vec3 toPoint) {
    if (mapLayers == 1) return 0;
    vec3 size = abs(toPoint);
    if (size.x >= size.y && size.x >= size.z) return toPoint.x > 0.0 ? 0 : 1;
    if (size.y >= size.z) return toPoint.y > 0.0 ? 2 : 3;
    return toPoint.z > 0.0 ? 4 : 5;
}

struct MapPlace {
    vec3 shadowUv; // u, v and depth, each 0..1 inside the map
    int layer;
    bool behind;   // on the far side of a spot's apex: the projection would mirror it
};

MapPlace mapPlace() {
    vec3 point = positionLightRelative * (1.0 - pullShare) + pullLightRelative;
    int layer = mapLayer(point);
    vec4 lightClip = lightClipFromLightRelative[layer] * vec4(point, 1.0);
    return MapPlace(lightClip.xyz / lightClip.w * 0.5 + 0.5, layer, lightClip.w <= 0.0);
}
