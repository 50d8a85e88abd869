// The map holds the middle between the first surface and the second, or the first pushed back by its slope where that is
// nearer: made when the map was drawn (dual_depth.frag). Nothing to do here.
vec4 biasedClip(vec4 lightClip, int layer) { return lightClip; }
float depthToCompare(MapPlace place, vec2 offsetUv) { return place.depth; }
