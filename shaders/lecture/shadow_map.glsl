// Does the light source see this point? The map says.
in vec4 positionLightClip;       // the point, in the clip space of the light's camera
uniform sampler2DArray depthMap; // d(u,v), from 0 to 1; beyond its border 1

// The point in light source coordinates (s, t, r), from 0 to 1. A point behind the lamp (w <= 0) is in no map: with r = -1 the
// comparison d < r is false, and it counts as lit.
// [anchor: map-coordinates]
vec3 lightCoordinates() {
    if (positionLightClip.w <= 0.0) return vec3(-1.0);
    vec3 str = 0.5 * positionLightClip.xyz / positionLightClip.w + 0.5;
    return vec3(str.xy, min(str.z, 1.0)); // beyond the last caster nothing is stored but 1
}

float lightDepth(vec3 str) { return texture(depthMap, vec3(str.xy, 0.0)).r; }

// [anchor: map-comparison]
float shadowVisibility() {
    vec3 str = lightCoordinates();
    float d = lightDepth(str);
    float z = str.z;
    return d < z ? 0.0 : 1.0;
}
