// The shadow map's answer: the share of comparisons in which nothing nearer to the light was found.
#include "shadow_map/lookup.glsl"
uniform int rejectBehind;
#include "shadow_map/filters/filter_hard.glsl"

// [anchor: map-visibility]
float visibilityIn(int layer) {
    MapPlace place = mapPlaceIn(layer);
    if (place.behind && rejectBehind == 1) return 1.0;
    return filteredVisibility(place);
}

float shadowVisibility() {
    int layer = mapLayer(positionLightRelative);
    float fade = fadeToNext();
    float visibility = visibilityIn(layer);
    return fade > 0.0 ? mix(visibility, visibilityIn(layer + 1), fade) : visibility;
}
