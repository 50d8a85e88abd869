// From a point relative to the light to its place in the shadow map: lecture 2's (u, v) and z.
in vec3 positionLightRelative;
uniform mat4 lightClipFromLightRelative[6];
uniform int mapLayers;
uniform float pullShare;        // share of the distance, and
uniform vec3 pullLightRelative; // offset, by which a point is moved toward the light against rounding
uniform float halfTexel;        // in units of the whole map: how far the texel's centre is off the point; 0: no slope bias
uniform float slopeStep;        // metres: length of the steps along the surface that its slope is taken from

// Of the six maps around a light, the one that looks along the largest component.
int mapLayer(vec3 toPoint) {
    if (mapLayers == 1) return 0;
    vec3 size = abs(toPoint);
    if (size.x >= size.y && size.x >= size.z) return toPoint.x > 0.0 ? 0 : 1;
    if (size.y >= size.z) return toPoint.y > 0.0 ? 2 : 3;
    return toPoint.z > 0.0 ? 4 : 5;
}

struct MapPlace {
    vec3 shadowUv; // u, v and the depth to compare with, each 0..1 inside the map
    float depth;   // of the point itself
    vec2 slope;    // of its plane: dz/du and dz/dv
    int layer;
    bool behind;   // on the far side of a spot's apex: the projection would mirror it
};

vec3 shadowUvOf(vec3 point, int layer) {
    vec4 lightClip = lightClipFromLightRelative[layer] * vec4(point, 1.0);
    return lightClip.xyz / lightClip.w * 0.5 + 0.5;
}

// (dz/du, dz/dv) of the receiver's plane: how depth varies across the map. A plane stays a plane in (u, v, z), so two
// steps along it tell, however long. After Isidoro, "Shadow Mapping: GPU-based Tips and Techniques", 2006.
vec2 receiverSlope(vec3 point, vec3 shadowUv, int layer) {
    vec3 alongX = dFdx(positionLightRelative), alongY = dFdy(positionLightRelative);
    vec3 stepX = shadowUvOf(point + slopeStep * normalize(alongX), layer) - shadowUv;
    vec3 stepY = shadowUvOf(point + slopeStep * normalize(alongY), layer) - shadowUv;
    float area = stepX.x * stepY.y - stepX.y * stepY.x;
    vec2 slope = vec2(stepX.z * stepY.y - stepY.z * stepX.y, stepY.z * stepX.x - stepX.z * stepY.x) / area;
    bool known = abs(slope.x) + abs(slope.y) >= 0.0; // not where eye or light see the plane exactly edge-on
    return known ? clamp(slope, -1e4, 1e4) : vec2(0.0);
}

MapPlace mapPlace() {
    vec3 point = positionLightRelative * (1.0 - pullShare) + pullLightRelative;
    int layer = mapLayer(point);
    vec4 lightClip = lightClipFromLightRelative[layer] * vec4(point, 1.0);
    vec3 shadowUv = lightClip.xyz / lightClip.w * 0.5 + 0.5;
    vec2 slope = receiverSlope(point, shadowUv, layer);
    float depth = shadowUv.z;
    shadowUv.z -= halfTexel * (abs(slope.x) + abs(slope.y)); // the texel's centre may be that far off
    return MapPlace(shadowUv, depth, slope, layer, lightClip.w <= 0.0);
}
