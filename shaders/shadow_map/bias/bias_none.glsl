// No bias: a texel holds the depth at its centre, and half of the surface around it is farther away than that. Acne.
vec4 biasedClip(vec4 lightClip, int layer) { return lightClip; }
float depthToCompare(MapPlace place, vec2 offsetUv) { return place.depth; }
