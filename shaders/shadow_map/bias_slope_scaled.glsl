// The depths in the map were pushed back by their own slope when they were drawn (glPolygonOffset): nothing to do here.
vec3 pointToAsk(vec3 pointLightRelative, int layer) { return pointLightRelative; }
float depthToCompare(MapPlace place, vec2 offsetUv) { return place.depth; }
