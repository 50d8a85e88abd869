#version 330 core
// Which pixels does the map decide for certain? Red: 0 in shadow, 1 lit, a half where a ray has to.
//
// The map knows which triangle is the first at the centre of the point's texel. Where that triangle is before the point
// itself, too, the point is in shadow, whatever else there is. Otherwise: where no loose edge in the texel is nearer to the
// light than the point's surface, all that lies before that surface are sheets, which cover the whole texel in one order.
// So the point is lit exactly if the sheet it lies on is the first one at the centre. The surface may be another triangle
// of the same sheet there: that is found by walking from the point to the centre.
#include "light.glsl"
#include "facing.glsl"
flat in int triangleOfScene;
in vec3 positionView;
#include "shadow_map/lookup.glsl"
uniform usampler2DArray firstTriangles; // of each texel's centre
uniform sampler2DArray shadowMap, edgeDepths;
#include "shadow_map/walk.glsl"
uniform int receivesShadow, castsShadow;
uniform int isDrawn;                // is the object in the map?
uniform float certainTexels;        // a centre nearer than this to an edge may be either triangle's, as the rasteriser rounds
uniform float depthEpsilon;                // depths that differ by less may be of surfaces that touch
out vec4 result;

const uint kNothing = 0xffffffffu;
// Of the texels from one pixel to the next: what the point's place may be wrong by. The rasteriser interpolates in float
// from the corner of the picture, so the error grows with the slope.
const float kPerPixel = 0.0005;
// Edges are drawn a tenth of a texel wider than they have to be.
const float kMostUncertain = 0.1;
const float kShadowed = 0.0, kAskRay = 0.5, kLit = 1.0;

// Is that triangle certainly between the light and the point?
bool isBefore(uint triangle, MapPlace place, vec2 texel, float certain) {
    MapTriangle t = mapTriangle(triangle, place.layer, texel);
    vec3 inside = insideOfEdges(t, vec2(0.0));
    vec2 depth = depthAndSlopeAt(t, vec2(0.0));
    float ownSlope = (abs(place.slope.x) + abs(place.slope.y)) / resolution;
    return t.beforeLight && !t.mayHaveHoles && min(inside.x, min(inside.y, inside.z)) > certain &&
           depth.x + depthEpsilon + certain * (depth.y + ownSlope) < place.depth;
}

float shadowedBeyond(vec2 depth, ivec3 address, float certain) {
    return depth.x > texelFetch(shadowMap, address, 0).r + depthEpsilon + certain * depth.y ? kShadowed : kAskRay;
}

// The point's surface is not the first at the texel's centre: `first` is. Is it before the point, or is the point on it after
// all, as another triangle of the same sheet?
float decideBehind(uint first, uint own, MapPlace place, vec2 texel, ivec3 address, float edge, float certain) {
    if (isBefore(first, place, texel, certain)) return kShadowed;
    vec2 centre = floor(texel) + 0.5 - texel;
    float slope = (abs(place.slope.x) + abs(place.slope.y)) / resolution; // per texel
    if (isDrawn == 0) {
        // A floor with everything before it is not in the map. What is seen but casts no shadow may be anywhere.
        vec2 depth = vec2(place.depth + dot(place.slope, centre / resolution), slope);
        return edge < 1.0 || castsShadow == 0 ? kAskRay : shadowedBeyond(depth, address, certain);
    }
    WalkEnd end = walk(own, place.layer, texel, centre);
    float farthest = max(place.depth + slope, end.farthest + certain * end.depth.y) + depthEpsilon;
    if (!end.arrived || edge <= farthest) return kAskRay;
    if (end.triangle == first) return kLit;
    return end.inside < certain ? kAskRay : shadowedBeyond(end.depth, address, certain);
}

// [anchor: decide-by-map]
float decide(int layer) {
    MapPlace place = mapPlaceIn(layer);
    vec2 texel = place.uv * resolution;
    bool outside = any(lessThan(texel, vec2(0.0))) || any(greaterThanEqual(texel, vec2(resolution)));
    if (place.behind || outside) return kLit; // no caster there
    float certain = certainTexels + kPerPixel * resolution * (length(place.pixelRight) + length(place.pixelUp));
    if (!(certain < kMostUncertain)) return kAskRay;
    ivec3 address = ivec3(floor(texel), layer);
    uint first = texelFetch(firstTriangles, address, 0).r, own = uint(triangleOfScene);
    float edge = texelFetch(edgeDepths, address, 0).r;
    if (first == kNothing) return edge < 1.0 ? kAskRay : kLit;
    float slope = (abs(place.slope.x) + abs(place.slope.y)) / resolution;
    if (first == own) return edge <= place.depth + slope + depthEpsilon ? kAskRay : kLit;
    return decideBehind(first, own, place, texel, address, edge, certain);
}

void main() {
    float distanceSquared;
    bool asked = eyeSideFacesLight() && lightShinesTo(towardLight(positionView, distanceSquared));
    float answer = !asked ? kShadowed : receivesShadow == 0 ? kLit : decide(mapLayer(positionLightRelative));
    result = vec4(answer, 1.0, 0.0, 1.0);
}
