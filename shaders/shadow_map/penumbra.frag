#version 330 core
// What percentage-closer soft shadows find out before they filter, in metres: how far before the point the surfaces are that
// block the light, and how wide the penumbra is that follows from it.
#include "light.glsl"
#include "facing.glsl"
in vec3 positionView;
#include "shadow_map/lookup.glsl"
#include "shadow_map/filters/filter_pcss.glsl"
uniform int mode; // 0 distance from the point to what blocks the light, 1 width of the penumbra
out vec4 result;

void main() {
    float distanceSquared;
    bool asked = eyeSideFacesLight() && lightShinesTo(towardLight(positionView, distanceSquared));
    MapPlace place = mapPlace();
    LightShape light = lightShape(place.layer);
    BlockerSearch search = searchBlockers(place, light, noiseAt(place));
    float lightWidth = 2.0 * (lightRadius > 0.0 ? lightRadius : max(length(lightHalfU), length(lightHalfV)));
    float width = lightWidth * min(magnification(search.receiver, search.blockers), light.mostMagnified);
    float value = mode == 0 ? search.receiver - search.blockers : width;
    result = vec4(value, asked && !place.behind && search.found > 0.0 ? 1.0 : 0.0, 0.0, 1.0);
}
