// The depths in the map were pushed back by their own slope when they were drawn (glPolygonOffset): nothing to do here.
vec4 biasedClip(vec4 lightClip, int layer) { return lightClip; }
float depthToCompare(MapPlace place, vec2 offsetUv) { return place.depth; }
