// No bias: a texel holds the depth at its centre, and half of the surface around it is farther away than that. Acne.
vec3 pointToAsk(vec3 pointLightRelative, int layer) { return pointLightRelative; }
float depthToCompare(MapPlace place, vec2 offsetUv) { return place.depth; }
