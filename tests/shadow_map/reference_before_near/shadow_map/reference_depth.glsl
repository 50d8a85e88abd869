// The naive one: a depth before the near plane is compared as it is, and what is clamped there is not nearer than that.
float referenceDepth(MapPlace place, vec2 offsetUv) { return min(depthToCompare(place, offsetUv), 1.0); }
