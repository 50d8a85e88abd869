// Each comparison takes the depth of the receiver's own plane over there, less half a texel of its slope, because the
// texel's centre may be that far off. Isidoro 2006; Schueler, "Eliminating Surface Acne with Gradient Shadow Mapping",
// ShaderX4, 2005.
uniform float halfTexel; // of the map's side, times slope-bias

vec4 biasedClip(vec4 lightClip, int layer) { return lightClip; }

float depthToCompare(MapPlace place, vec2 offsetUv) {
    // Never a depth behind the point itself: beyond its edge the surface does not go on.
    float toward = halfTexel > 0.0 ? min(dot(place.slope, offsetUv), 0.0) : 0.0;
    return place.depth - halfTexel * (abs(place.slope.x) + abs(place.slope.y)) + toward;
}
