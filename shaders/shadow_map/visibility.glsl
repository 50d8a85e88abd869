// The shadow map's answer: the share of comparisons in which nothing nearer to the light was found.
#include "shadow_map/lookup.glsl"
uniform sampler2DArrayShadow shadowMap;
#include "shadow_map/filter.glsl"

float shadowVisibility() {
    MapPlace place = mapPlace();
    if (place.behind) return 1.0;
    return filteredVisibility(place);
}
