// Percentage-closer soft shadows: the farther what blocks the light is from the surface, the wider the kernel. Fernando,
// "Percentage-Closer Soft Shadows", SIGGRAPH Sketches, 2005.
//
//   1. search: the mean distance d_b of the surfaces that stand before the point, d_r being the point's own
//   2. the penumbra is w = w_L (d_r - d_b) / d_b wide, for a light that is w_L wide
//   3. filter: the share of comparisons over that width which are lit
//
// Exact where the light and one blocker are parallel. So distances count at right angles to the light's own surface, however
// the map's camera is turned: along its axis a blocker to one side would seem farther than to the other. Search and filter look
// through the light's own shape, as the surface sees it through a hole at the blocker: a rectangle's, or a disc for a ball.
uniform sampler2DArray shadowMap; // depths, not compared by the sampler
uniform int samples, blockerSamples;
uniform vec3 lightHalfU, lightHalfV; // light-relative: half edges of a rectangle; for a disc both are in any direction
uniform float lightRadius;           // metres, of a disc; a directional light: at a distance of 1 m. 0: a rectangle
uniform vec3 lightAxis;              // unit: the way a rectangle or the sun faces; zero: a disc faces the point
uniform float nearestBlocker;        // metres: nothing is nearer to the light than that
uniform float widest;                // share of the map that a kernel may reach to each side
uniform mat4 lightRelativeFromLightClip[6];
#include "shadow_map/sample_points.glsl"

// The light's half axes in the clip space of a map, per metre of the point's offset on the receiver.
struct LightShape {
    vec4 clip, clipU, clipV;
    float mostMagnified; // so that it is no larger than `widest` in the map: all of it shrinks, none of it is cut off
};

LightShape lightShape(int layer) {
    vec3 halfU = lightHalfU, halfV = lightHalfV;
    if (lightRadius > 0.0) { // a disc that faces the point
        vec3 toward = towardLightFrom(positionLightRelative);
        vec3 aside = abs(toward.x) < 0.8 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
        halfU = lightRadius * normalize(cross(toward, aside));
        halfV = cross(toward, halfU);
    }
    vec4 clip = biasedClip(lightClipIn(layer), layer) * roundingBiasScale + roundingBiasClip[layer];
    vec4 clipU = lightClipFromLightRelative[layer] * vec4(halfU, 0.0);
    vec4 clipV = lightClipFromLightRelative[layer] * vec4(halfV, 0.0);
    vec2 alongU = clipU.xy - clip.xy / clip.w * clipU.w, alongV = clipV.xy - clip.xy / clip.w * clipV.w;
    vec2 reach = lightRadius > 0.0 ? sqrt(alongU * alongU + alongV * alongV) : abs(alongU) + abs(alongV);
    return LightShape(clip, clipU, clipV, widest * 2.0 * abs(clip.w) / max(max(reach.x, reach.y), 1e-30));
}

// Where in the map the ray to a point of the light passes a blocker, of which the light's shape is seen `magnified` at the
// receiver: the place where the map, which looks from the light's middle, sees what is on that ray.
vec2 offsetThrough(vec2 onLight, float magnified, LightShape light, MapPlace place) {
    vec4 clip = light.clip + magnified * (onLight.x * light.clipU + onLight.y * light.clipV);
    return clip.xy / clip.w * 0.5 + 0.5 - place.uv;
}

bool lightIsParallel() { return towardLightRelative != vec3(0.0); }

// w / w_L: how large the light's shape is on the receiver, seen through a hole at that distance.
float magnification(float receiver, float blocker) {
    float between = max(receiver - blocker, 0.0);
    return lightIsParallel() ? between : between / max(blocker, 1e-3 * receiver); // what is beside a rectangle is at no distance
}

vec2 pointOnLight(int i, int count, vec2 chance) {
    return lightRadius > 0.0 ? pointInDisc(i, count, chance) : pointInSquare(i, chance);
}

struct BlockerSearch {
    float receiver, blockers; // metres from the light, along its axis: the point, and the mean of what is before it
    float found;              // of the depths looked at: how many
};

BlockerSearch searchBlockers(MapPlace place, LightShape light, vec2 chance) {
    vec3 axis = lightAxis == vec3(0.0) ? normalize(positionLightRelative) : lightAxis;
    // The distance of what is at a place in the map is a quotient: of these two times that place.
    vec4 along = vec4(axis, 0.0) * lightRelativeFromLightClip[place.layer];
    vec4 weight = vec4(0.0, 0.0, 0.0, 1.0) * lightRelativeFromLightClip[place.layer];
    float receiver = dot(axis, positionLightRelative), sum = 0.0, found = 0.0;
    // Along the point's own ray all distances shrink alike, whichever axis they count along.
    float most = magnification(lightIsParallel() ? receiver : length(positionLightRelative), nearestBlocker);
    float magnified = min(most, light.mostMagnified);
    for (int i = 0; i < blockerSamples; ++i) {
        vec2 offsetUv = offsetThrough(pointOnLight(i, blockerSamples, chance), magnified, light, place);
        float depth = texture(shadowMap, vec3(place.uv + offsetUv, float(place.layer))).r;
        if (depth >= referenceDepth(place, offsetUv)) continue;
        vec4 clip = vec4(vec3(place.uv + offsetUv, depth) * 2.0 - 1.0, 1.0);
        sum += dot(along, clip) / dot(weight, clip);
        found += 1.0;
    }
    return BlockerSearch(receiver, sum / max(found, 1.0), found);
}

// [anchor: compare-pcss]
float filteredVisibility(MapPlace place) {
    vec2 chance = noiseAt(place);
    LightShape light = lightShape(place.layer);
    BlockerSearch search = searchBlockers(place, light, chance);
    if (search.found == 0.0) return 1.0;
    float magnified = min(magnification(search.receiver, search.blockers), light.mostMagnified), lit = 0.0;
    for (int i = 0; i < samples; ++i) {
        vec2 offsetUv = offsetThrough(pointOnLight(i, samples, chance), magnified, light, place);
        float depth = texture(shadowMap, vec3(place.uv + offsetUv, float(place.layer))).r;
        lit += depth >= referenceDepth(place, offsetUv) ? 1.0 : 0.0;
    }
    return lit / float(samples);
}
