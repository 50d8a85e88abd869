// The moments around a point, averaged over the texels beside it and over as many as a pixel covers.
#include "shadow_map/moment_depth.glsl"
uniform sampler2DArray moments;
uniform int outsideIsLit;

bool isOutside(MapPlace place) {
    return outsideIsLit == 1 && any(greaterThan(abs(place.uv - 0.5), vec2(0.5)));
}

vec4 momentsAt(MapPlace place) {
    return textureGrad(moments, vec3(place.uv, float(place.layer)), place.pixelRight, place.pixelUp);
}

float receiverMomentDepth(MapPlace place) {
    return momentDepth(distanceRows(place.layer), place.uv, referenceDepth(place, vec2(0.0)));
}
