#version 330 core
// The map projected onto what the eye sees: its depth d(u,v), the point's own distance z(u,v), the two compared, or where
// the points are.
#include "light.glsl"
#include "facing.glsl"
in vec3 positionView;
#include "shadow_map/lookup.glsl"
#include "shadow_map/distance.glsl"
uniform sampler2DArray shadowMap;
uniform int mode; // 0 depth in the map, 1 distance of the point, 2 comparison, 3 position relative to the light, 4 plane
uniform vec3 equalColor, occludedColor, nothingStoredColor, notAskedColor;
out vec4 result;

vec3 comparison(MapPlace place, float stored, bool inside) {
    float distanceSquared;
    bool asked = eyeSideFacesLight() && lightShinesTo(towardLight(positionView, distanceSquared));
    if (!asked) return notAskedColor;
    if (!inside || stored == 1.0) return nothingStoredColor;
    return stored < referenceDepth(place, vec2(0.0)) ? occludedColor : equalColor;
}

void main() {
    MapPlace place = mapPlace();
    float stored = texture(shadowMap, vec3(place.uv, float(place.layer))).r;
    bool inside = !place.behind && all(lessThan(abs(place.uv - 0.5), vec2(0.5)));
    float distance = distanceOf(place.uv, mode == 0 ? stored : place.depth, place.layer);
    if (mode == 0) result = vec4(distance, inside && stored < 1.0 ? 1.0 : 0.0, 0.0, 1.0);
    if (mode == 1) result = vec4(distance, place.behind ? 0.0 : 1.0, 0.0, 1.0);
    if (mode == 2) result = vec4(comparison(place, stored, inside), 1.0);
    if (mode == 3) result = vec4(positionLightRelative, 1.0);
    if (mode == 4) result = vec4(referenceDepth(place, vec2(0.0)), place.slope, 1.0);
}
