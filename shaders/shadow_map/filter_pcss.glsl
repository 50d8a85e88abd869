// Percentage-closer soft shadows: the farther what blocks the light is from the surface, the wider the kernel. Fernando,
// "Percentage-Closer Soft Shadows", SIGGRAPH Sketches, 2005.
//
//   1. search: the mean distance d_b of the surfaces that stand before the point, d_r being the point's own
//   2. the penumbra is w = w_L (d_r - d_b) / d_b wide, for a light that is w_L wide
//   3. filter: the share of comparisons over that width which are lit
//
// Exact where the light, one blocker and the receiver are parallel. Search and filter look through the light's own shape, as
// the surface sees it through a hole at the blocker: a rectangle's, or a disc for a ball.
uniform sampler2DArray shadowMap; // depths, not compared by the sampler
uniform int samples, blockerSamples;
uniform vec3 lightHalfU, lightHalfV; // light-relative: half edges of a rectangle; for a disc both are in any direction
uniform float lightRadius;           // metres, of a disc; a directional light: at a distance of 1 m. 0: a rectangle
uniform float nearestBlocker;        // metres along the camera's axis: nothing is nearer to the light than that
uniform float widest;                // share of the map that a kernel may reach to each side
#include "shadow_map/distance.glsl"
#include "shadow_map/sample_points.glsl"

// The light's half axes in the clip space of a map, per metre of the point's offset on the receiver.
struct LightShape {
    vec4 clip, clipU, clipV;
};

LightShape lightShape(int layer) {
    vec3 halfU = lightHalfU, halfV = lightHalfV;
    if (lightRadius > 0.0) { // a disc that faces the point
        vec3 toward = towardLightFrom(positionLightRelative);
        vec3 aside = abs(toward.x) < 0.8 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
        halfU = lightRadius * normalize(cross(toward, aside));
        halfV = cross(toward, halfU);
    }
    return LightShape(biasedClip(lightClipIn(layer), layer) * pullScale + pullClip[layer],
                      lightClipFromLightRelative[layer] * vec4(halfU, 0.0),
                      lightClipFromLightRelative[layer] * vec4(halfV, 0.0));
}

// Where in the map the ray to a point of the light passes a blocker, of which the light's shape is seen `magnified` at the
// receiver: the place where the map, which looks from the light's middle, sees what is on that ray.
vec2 offsetThrough(vec2 onLight, float magnified, LightShape light, MapPlace place) {
    vec4 clip = light.clip + magnified * (onLight.x * light.clipU + onLight.y * light.clipV);
    return clamp(clip.xy / clip.w * 0.5 + 0.5 - place.uv, -widest, widest);
}

// w / w_L: how large the light's shape is on the receiver, seen through a hole at that distance.
float magnification(float receiver, float blocker) {
    bool parallel = towardLightRelative != vec3(0.0);
    return parallel ? receiver - blocker : (receiver - blocker) / blocker;
}

vec2 pointOnLight(int i, int count, vec2 chance) {
    return lightRadius > 0.0 ? pointInDisc(i, count, chance) : pointInSquare(i, chance);
}

struct BlockerSearch {
    float receiver, blockers; // metres along the camera's axis: the point, and the mean of what is before it
    float found;              // of the depths looked at: how many
};

BlockerSearch searchBlockers(MapPlace place, LightShape light, vec2 chance) {
    float receiver = axialDistance(place.uv, place.depth, place.layer), sum = 0.0, found = 0.0;
    float magnified = magnification(receiver, min(nearestBlocker, receiver));
    for (int i = 0; i < blockerSamples; ++i) {
        vec2 offsetUv = offsetThrough(pointOnLight(i, blockerSamples, chance), magnified, light, place);
        float depth = texture(shadowMap, vec3(place.uv + offsetUv, float(place.layer))).r;
        if (depth >= referenceDepth(place, offsetUv)) continue;
        sum += axialDistance(place.uv + offsetUv, depth, place.layer);
        found += 1.0;
    }
    return BlockerSearch(receiver, sum / max(found, 1.0), found);
}

float filteredVisibility(MapPlace place) {
    vec2 chance = noiseAt(place);
    LightShape light = lightShape(place.layer);
    BlockerSearch search = searchBlockers(place, light, chance);
    if (search.found == 0.0) return 1.0;
    float magnified = magnification(search.receiver, search.blockers), lit = 0.0;
    for (int i = 0; i < samples; ++i) {
        vec2 offsetUv = offsetThrough(pointOnLight(i, samples, chance), magnified, light, place);
        float depth = texture(shadowMap, vec3(place.uv + offsetUv, float(place.layer))).r;
        lit += depth >= referenceDepth(place, offsetUv) ? 1.0 : 0.0;
    }
    return lit / float(samples);
}
