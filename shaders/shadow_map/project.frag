#version 330 core
// The map projected onto what the eye sees: its depth d(u,v), the point's own distance z(u,v), or the two compared.
#include "light.glsl"
#include "facing.glsl"
#include "shadow_map/lookup.glsl"
#include "shadow_map/linear_depth.glsl"
in vec3 positionView;
uniform sampler2DArray shadowMap;
uniform int mode; // 0 depth in the map, 1 distance of the point, 2 comparison
uniform vec3 equalColor, occludedColor, noAnswerColor;
out vec4 result;

void main() {
    MapPlace place = mapPlace();
    float stored = texture(shadowMap, vec3(place.shadowUv.xy, float(place.layer))).r;
    bool inside = !place.behind && all(lessThan(abs(place.shadowUv.xy - 0.5), vec2(0.5)));
    if (mode == 0) {
        result = vec4(distanceOfDepth(stored), inside && stored < 1.0 ? 1.0 : 0.0, 0.0, 1.0);
    } else if (mode == 1) {
        result = vec4(distanceOfDepth(place.depth), place.behind ? 0.0 : 1.0, 0.0, 1.0);
    } else {
        float distanceSquared;
        bool asked = eyeSideFacesLight() && lightShinesTo(towardLight(positionView, distanceSquared));
        bool occluded = inside && stored < clamp(place.shadowUv.z, 0.0, 1.0);
        result = vec4(!asked ? noAnswerColor : occluded ? occludedColor : equalColor, 1.0);
    }
}
