// A step along the receiver's normal: it leads out of the surface's own texels sideways, so it is never much larger than they
// are, however grazing the light. Holbert, "Saying Goodbye to Shadow Acne", GDC 2011.
//
// A kernel that reaches r texels to each side looks along rays up to |e| = (r + 1/2) sqrt(2) texels beside the point's own. On
// a plane with the normal n, its angle to the direction l toward the light being theta, the ray at e meets the plane
// dot(e, n) / cos(theta) nearer to the light, and a step h along n raises the point by h / cos(theta) along its ray. So far
// |e| sin(theta) would do. But depths are not compared along rays: with a gradient g of depth (the direction of a perspective
// map's axis) they differ by e on its own. Both together ask for |e| times the length of
//     n - g cos(theta) / dot(g, l), at right angles to l.
// That is sin(theta) in a parallel map, and nothing on a plane of constant depth.
uniform float normalOffset; // 1: just that
uniform float kernelTexels; // r + 1/2

vec4 biasedClip(vec4 lightClip, int layer) {
    vec3 normal = normalize(cross(rightLightRelative, upLightRelative));
    vec3 towardLight = towardLightFrom(positionLightRelative);
    float cosine = dot(normal, towardLight);
    if (cosine < 0.0) {
        normal = -normal;
        cosine = -cosine;
    }
    // Depth is the quotient z / w: its gradient, but for a factor.
    mat4 rows = transpose(lightClipFromLightRelative[layer]);
    vec3 gradient = rows[2].xyz * lightClip.w - rows[3].xyz * lightClip.z;
    vec3 nearer = normal - gradient * (cosine / dot(gradient, towardLight));
    nearer -= towardLight * dot(nearer, towardLight);
    float metres = normalOffset * kernelTexels * 1.4142136 * texelMetres(lightClip, layer) * length(nearer);
    bool known = metres >= 0.0; // not where the eye sees the surface exactly edge-on
    return known ? lightClip + lightClipFromLightRelative[layer] * vec4(metres * normal, 0.0) : lightClip;
}
float depthToCompare(MapPlace place, vec2 offsetUv) { return place.depth; }
