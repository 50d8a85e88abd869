// From a point relative to the light to its place in the shadow map: lecture 2's (s, t, r), or (u, v) and z.
//
// Wants positionView declared before. Of point_*.glsl (where the point is), layer_*.glsl (which map holds it) and bias_*.glsl
// (what keeps a surface from shadowing itself) the simplest are included here; the program puts the chosen ones in their place.
#include "shadow_map/point_light.glsl"
uniform mat4 lightClipFromLightRelative[6];
uniform vec3 towardLightRelative; // unit, of a directional light; zero for one that is at the origin
uniform float roundingBiasScale;  // Against rounding a point is moved toward the light by 1e-5 of the distance. In clip
uniform vec4 roundingBiasClip[6]; // space that is a point times this scale plus this vector, one for each map.
uniform float resolution;         // texels along a side of the map

// From this pixel to the next, to the right and upward, along the surface. Taken before main(): a difference between neighbours is
// defined only where all of them come by, and not in a branch that some take (beside the border of a spot's cone).
vec3 rightLightRelative = dFdx(positionLightRelative), upLightRelative = dFdy(positionLightRelative);

// The same in clip space.
struct LightSteps {
    vec4 alongX, alongY;
};

#include "shadow_map/layers/layer_one.glsl"

// The point's place in one of the maps.
struct MapPlace {
    vec2 uv;     // 0..1 inside the map
    float depth; // z(u, v): of the point itself, 0..1
    vec2 slope;  // of its plane: dz/du and dz/dv
    vec2 pixelRight, pixelUp; // what uv changes by from pixel to pixel
    int layer;
    bool behind; // on the far side of a spot's apex: the projection would mirror it
};

vec3 towardLightFrom(vec3 point) {
    return towardLightRelative == vec3(0.0) ? -normalize(point) : towardLightRelative;
}

// (dz/du, dz/dv) of the receiver's plane: how depth varies across the map. A plane stays a plane in (u, v, z), so two steps
// along it tell. After Isidoro, "Shadow Mapping: GPU-based Tips and Techniques", 2006, who takes differences of (u, v, z)
// themselves; the way in which a quotient changes keeps the digits that a difference of quotients loses.
vec2 receiverSlope(vec3 stepX, vec3 stepY) {
    float area = stepX.x * stepY.y - stepX.y * stepY.x;
    vec2 slope = vec2(stepX.z * stepY.y - stepY.z * stepX.y, stepY.z * stepX.x - stepX.z * stepY.x) / area;
    bool known = abs(slope.x) + abs(slope.y) >= 0.0; // not where eye or light see the plane exactly edge-on
    return known ? clamp(slope, -1e4, 1e4) : vec2(0.0);
}

// Metres that a texel measures, at right angles to the light, where the point is: in the direction in which it is longest.
// Beside the axis of a perspective map texels are skewed, and longer than either of their sides.
float texelMetres(vec4 lightClip, int layer) {
    mat4 rows = transpose(lightClipFromLightRelative[layer]);
    // u and v are quotients; these are their gradients. Along the light's ray neither changes.
    vec3 alongU = (rows[0].xyz * lightClip.w - rows[3].xyz * lightClip.x) / (lightClip.w * lightClip.w);
    vec3 alongV = (rows[1].xyz * lightClip.w - rows[3].xyz * lightClip.y) / (lightClip.w * lightClip.w);
    // How fast (u, v) changes in the direction in which it does so least: the smaller singular value of both together.
    float u = dot(alongU, alongU), v = dot(alongV, alongV), mixed = dot(alongU, alongV);
    float least = sqrt(max(0.5 * (u + v) - length(vec2(0.5 * (u - v), mixed)), 1e-6 * (u + v)));
    return 2.0 / (resolution * least);
}

#include "shadow_map/bias/bias_none.glsl"

// [anchor: map-place]
MapPlace mapPlaceIn(int layer) {
    vec4 lightClip = biasedClip(lightClipIn(layer), layer) * roundingBiasScale + roundingBiasClip[layer];
    vec3 lightNdc = lightClip.xyz / lightClip.w;
    vec3 shadowUv = lightNdc * 0.5 + 0.5;
    LightSteps steps = lightStepsIn(layer);
    vec3 stepX = steps.alongX.xyz - lightNdc * steps.alongX.w; // times w: of the quotient
    vec3 stepY = steps.alongY.xyz - lightNdc * steps.alongY.w;
    return MapPlace(shadowUv.xy, shadowUv.z, receiverSlope(stepX, stepY), 0.5 / lightClip.w * stepX.xy,
                    0.5 / lightClip.w * stepY.xy, layer, lightClip.w <= 0.0);
}

MapPlace mapPlace() { return mapPlaceIn(mapLayer(positionLightRelative)); }

// What a comparison at `offsetUv` from the point's place compares with the map.
#include "shadow_map/reference_depth.glsl"
