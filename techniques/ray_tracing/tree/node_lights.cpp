// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/tree/node_lights.h"

#include <algorithm>

#include "techniques/foundation/scene/query/shading.h"
#include "techniques/ray_tracing/sampling/light_sampling.h"

namespace shadowlab::ray_tracing {

namespace {

/// The visibility of the light's centre: as in all techniques, where nothing moves; else by the same tests in double, at that
/// time.
trace::Visibility visibilityOfCentre(const RayWorld& world, const TreeSettings& settings, const TreeNode& node,
                                     int light, const dvec3& positionWorld) {
    const trace::SceneTracer& tracer = world.surfaces.tracer();
    if (!world.scene.moves() || world.time == 0) return tracer.visibility(node.point, light, settings.start);
    const scene::Light& source = tracer.scene().light(light);
    if (!scene::lightShinesTo(source, positionWorld)) return trace::Visibility::turnedAway;
    // A directional light is far beyond everything in the scene.
    const double far = 4 * tracer.largestCentred() + glm::length(node.positionCentred);
    return visibilityAlong(world, settings, node, light,
                           source.type == scene::LightType::directional ? -far * source.directionWorld
                                                                        : source.positionWorld - positionWorld);
}

/// One sample on the light: its contribution if all of the light were as visible as this point.
LightAtNode sampledLight(const RayWorld& world, const TreeSettings& settings, const TreeNode& node, int light,
                         const dvec3& positionWorld) {
    const Surfaces& surfaces = world.surfaces;
    const scene::Light& source = surfaces.scene().light(light);
    const std::uint64_t place = node.placeOf(light, surfaces.scene().lights.size());
    const LightSample sample = sampleLight(source, positionWorld, world.numbers->pair(Purpose::light, place));
    LightAtNode at;
    at.visibility = trace::Visibility::turnedAway;
    at.towardWorld = scene::towardLightWorld(source, positionWorld);
    if (!(sample.solidAngle > 0)) return at;
    at.towardWorld = sample.towardWorld;
    at.toPlace = sample.onLightCentredOffset;
    at.areaWeight = sample.areaWeight;
    at.visibility = visibilityAlong(world, settings, node, light, sample.onLightCentredOffset);
    if (at.visibility != trace::Visibility::lit) return at;
    const double cosine = std::max(0.0, glm::dot(node.normalWorld, sample.towardWorld));
    at.intensity = dvec3(source.color) * source.intensity * sample.solidAngle * cosine *
                   scene::reflectance(surfaces.materialOf(node.point), dvec3(surfaces.diffuseOf(node.point)), node.normalWorld, sample.towardWorld, -node.u);
    return at;
}

// Relative to the cut-off, which is half a step of 8-bit grey among light colours. Near black, where sRGB steps are thirteen
// times smaller, this is a ninth of half a step, so that many faint lights together stay below a step.
constexpr double kFaint = 0.008;

/// Is the light's contribution invisible? On glass it mostly is: a lamp adds only a highlight some pixels wide.
bool isFaint(const TreeNode& node, const TreeSettings& settings, const dvec3& intensity, double exposure) {
    const double most = std::max({intensity.x, intensity.y, intensity.z});
    return node.contribution * most * exposure < kFaint * settings.cutoff;
}

LightAtNode analyticLight(const RayWorld& world, const TreeNode& node, int light, const dvec3& positionWorld) {
    const Surfaces& surfaces = world.surfaces;
    const scene::Light& source = surfaces.scene().light(light);
    trace::AreaIrradiance found;
    world.analytic->area(light)->irradiances({&node.point, 1}, {&node.normalWorld, 1}, {&found, 1});
    LightAtNode at;
    at.towardWorld = scene::towardLightWorld(source, positionWorld);
    at.visibility = found.irradiance > 0   ? trace::Visibility::lit
                    : found.unshadowed > 0 ? trace::Visibility::shadowed
                                           : trace::Visibility::turnedAway;
    at.intensity = surfaces.litByArea(node.point, light, found.irradiance, positionWorld, node.normalWorld, -node.u);
    return at;
}

} // namespace

trace::Visibility visibilityAlong(const RayWorld& world, const TreeSettings& settings, const TreeNode& node, int light,
                                  const dvec3& offset) {
    const Surfaces& surfaces = world.surfaces;
    if (!(glm::dot(surfaces.geometricNormalWorld(node.point), offset) > 0)) return trace::Visibility::turnedAway;
    if (!surfaces.tracer().objectOf(node.point).receivesShadow) return trace::Visibility::lit;
    const bool naive = settings.start == trace::ShadowStart::naive;
    trace::Ray ray;
    ray.originCentred = naive ? dvec3(vec3(node.positionCentred)) : node.positionCentred;
    ray.directionCentred = offset;
    ray.nearest = naive ? 0 : trace::kContact;
    ray.farthest = 1.0;
    const std::uint32_t leftOut = naive ? trace::kNoPrimitive : node.point.primitive;
    return world.scene.isBlocked(ray, leftOut, world.time, light) ? trace::Visibility::shadowed
                                                                  : trace::Visibility::lit;
}

LightAtNode lightAt(const RayWorld& world, const TreeSettings& settings, const TreeNode& node, int light) {
    const Surfaces& surfaces = world.surfaces;
    const scene::Light& source = surfaces.scene().light(light);
    const dvec3 positionWorld = surfaces.tracer().world().originWorld + node.positionCentred;
    const bool stands = !world.scene.moves() || world.time == 0;
    LightAtNode at;
    if (settings.areaLights == AreaLights::analytic && world.analytic && scene::hasArea(source) && stands) {
        at = analyticLight(world, node, light, positionWorld);
    } else if (world.numbers && settings.areaLights != AreaLights::centre && scene::hasArea(source)) {
        at = sampledLight(world, settings, node, light, positionWorld);
    } else {
        at.towardWorld = scene::towardLightWorld(source, positionWorld);
        const dvec3 lit = surfaces.lit(node.point, light, positionWorld, node.normalWorld, -node.u);
        if (settings.skipsFaint && isFaint(node, settings, lit, surfaces.scene().exposure)) return at;
        at.visibility = visibilityOfCentre(world, settings, node, light, positionWorld);
        if (at.visibility == trace::Visibility::lit) at.intensity = lit;
    }
    at.halfwayWorld = glm::normalize(at.towardWorld - node.u);
    return at;
}

} // namespace shadowlab::ray_tracing
