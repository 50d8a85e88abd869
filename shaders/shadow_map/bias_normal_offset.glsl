// A step along the receiver's normal: it leads out of the surface's own texels sideways, so it is never larger than they
// are, however grazing the light. Holbert, "Saying Goodbye to Shadow Acne", GDC 2011.
//
// On a plane whose normal has the angle theta to the light, a kernel that reaches r texels to each side meets depths up to
// (r + 1/2) sqrt(2) texels tan(theta) nearer; a step h along the normal raises the point by h / cos(theta).
uniform float normalOffset; // 1: just that
uniform float kernelTexels; // r + 1/2

vec3 pointToAsk(vec3 pointLightRelative, int layer) {
    vec3 normal = normalize(cross(dFdx(positionLightRelative), dFdy(positionLightRelative)));
    vec3 towardLight = towardLightFrom(pointLightRelative);
    float cosine = dot(normal, towardLight);
    if (cosine < 0.0) normal = -normal;
    float sine = sqrt(max(0.0, 1.0 - cosine * cosine));
    float metres = normalOffset * kernelTexels * 1.4142136 * texelMetres(pointLightRelative, layer) * sine;
    bool known = metres >= 0.0; // not where the eye sees the surface exactly edge-on
    return known ? pointLightRelative + metres * normal : pointLightRelative;
}
float depthToCompare(MapPlace place, vec2 offsetUv) { return place.depth; }
