// The depth that is compared with the map. Wants MapPlace and depthToCompare declared before.
//
// Never beyond the map's range, where nothing is kept. And never before it, if all of the object is beyond the near plane: then
// a 0 in the map is something else, clamped there, and nearer however far a steep plane seems to reach toward the light.
uniform float minReferenceDepth; // techniques/shadow_map/fit/light_maps.h

float referenceDepth(MapPlace place, vec2 offsetUv) {
    return clamp(depthToCompare(place, offsetUv), minReferenceDepth, 1.0);
}
