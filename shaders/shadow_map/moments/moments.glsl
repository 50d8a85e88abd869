// The moments around a point, averaged over the texels beside it and over as many as a pixel covers.
#include "shadow_map/moments/moment_depth.glsl"
uniform sampler2DArray moments;
uniform int outsideIsLit;

bool isOutside(MapPlace place) {
    return outsideIsLit == 1 && any(greaterThan(abs(place.uv - 0.5), vec2(0.5)));
}

vec4 momentsAt(MapPlace place) {
    // A coarse texel at the border averages texels of one side only: there the finest level is read.
    vec2 reach = 2.0 * max(abs(place.pixelRight), abs(place.pixelUp));
    if (any(lessThan(0.5 - abs(place.uv - 0.5), vec2(max(reach.x, reach.y)))))
        return textureLod(moments, vec3(place.uv, float(place.layer)), 0.0);
    return textureGrad(moments, vec3(place.uv, float(place.layer)), place.pixelRight, place.pixelUp);
}

// Moments are interpolated between the centres of texels, so the depth of the point itself is compared.
float receiverMomentDepth(MapPlace place) {
#ifdef COMPARES_AT_CENTRES
    float depth = min(place.depth, 1.0);
#else
    float depth = referenceDepth(place, vec2(0.0));
#endif
    return momentDepth(distanceRows(place.layer), place.uv, depth);
}
