// From a point relative to the light to its place in the shadow map: lecture 2's (s, t, r), or (u, v) and z.
//
// Wants positionView declared before, and shadow_map/layer.glsl and shadow_map/bias.glsl chosen among the files of those
// names: which map to ask, and what keeps a surface from shadowing itself.
in vec3 positionLightRelative;
uniform mat4 lightClipFromLightRelative[6];
uniform vec3 towardLightRelative; // unit, of a directional light; zero for one that is at the origin
uniform float roundingShare;      // of the distance to the light, or of `roundingMetres` for a directional one: how far points
uniform float roundingMetres;     // are moved toward the light against rounding
uniform float slopeStep;          // metres: length of the steps along the surface that its slope is taken from
uniform float resolution;         // texels along a side of the map

#include "shadow_map/layer.glsl"

// The point's place in one of the maps.
struct MapPlace {
    vec2 uv;     // 0..1 inside the map
    float depth; // z(u, v): of the point itself, 0..1
    vec2 slope;  // of its plane: dz/du and dz/dv
    int layer;
    bool behind; // on the far side of a spot's apex: the projection would mirror it
};

vec3 shadowUvOf(vec3 point, int layer) {
    vec4 lightClip = lightClipFromLightRelative[layer] * vec4(point, 1.0);
    return lightClip.xyz / lightClip.w * 0.5 + 0.5;
}

vec3 towardLightFrom(vec3 point) {
    return towardLightRelative == vec3(0.0) ? -normalize(point) : towardLightRelative;
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

// Metres that a texel measures, at right angles to the light, where the point is: in the direction in which it is longest.
// Beside the axis of a perspective map texels are skewed, and longer than either of their sides.
float texelMetres(vec3 point, int layer) {
    mat4 rows = transpose(lightClipFromLightRelative[layer]);
    vec4 lightClip = lightClipFromLightRelative[layer] * vec4(point, 1.0);
    // u and v are quotients; these are their gradients. Along the light's ray neither changes.
    vec3 alongU = (rows[0].xyz * lightClip.w - rows[3].xyz * lightClip.x) / (lightClip.w * lightClip.w);
    vec3 alongV = (rows[1].xyz * lightClip.w - rows[3].xyz * lightClip.y) / (lightClip.w * lightClip.w);
    // How fast (u, v) changes in the direction in which it does so least: the smaller singular value of both together.
    float u = dot(alongU, alongU), v = dot(alongV, alongV), mixed = dot(alongU, alongV);
    float least = sqrt(max(0.5 * (u + v) - length(vec2(0.5 * (u - v), mixed)), 1e-6 * (u + v)));
    return 2.0 / (resolution * least);
}

#include "shadow_map/bias.glsl"

MapPlace mapPlaceIn(int layer) {
    vec3 point = pointToAsk(positionLightRelative, layer);
    float toLight = towardLightRelative == vec3(0.0) ? length(point) : roundingMetres;
    point += roundingShare * toLight * towardLightFrom(point);
    vec4 lightClip = lightClipFromLightRelative[layer] * vec4(point, 1.0);
    vec3 shadowUv = lightClip.xyz / lightClip.w * 0.5 + 0.5;
    return MapPlace(shadowUv.xy, shadowUv.z, receiverSlope(point, shadowUv, layer), layer, lightClip.w <= 0.0);
}

MapPlace mapPlace() { return mapPlaceIn(mapLayer(positionLightRelative)); }

// What a comparison at `offsetUv` from the point's place compares with the map: never beyond its range.
float referenceDepth(MapPlace place, vec2 offsetUv) { return min(depthToCompare(place, offsetUv), 1.0); }
