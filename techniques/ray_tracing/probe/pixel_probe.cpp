// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/probe/pixel_probe.h"

#include "techniques/foundation/trace/area/area_visibility.h"
#include "techniques/probed/seen_point.h"
#include "techniques/ray_tracing/structures/structure_shapes.h"

namespace shadowlab::ray_tracing {

namespace {

/// How many volumes and triangles the pixel's rays test, and what of the structure the eye ray passes.
void describeTests(const PixelQuery& query, const trace::EyeRays& rays, const trace::SurfacePoint& point,
                   Probe& probe) {
    const trace::SceneTracer& tracer = query.tracer;
    const trace::Engine& engine = query.structures.engine();
    const dvec2 centre = dvec2(query.pixel) + 0.5;
    const trace::RayTests tests = tracer.testsOf(engine, rays, centre);
    if (engine.counts())
        probe.facts.insert(probe.facts.end(), {probeCount("eye ray and shadow rays try", tests.volumes, "volumes"),
                                               probeCount("and", tests.triangles, "triangles"),
                                               probeCount("looking into", tests.steps, "nodes, objects or cells")});
    trace::Ray toHit = rays.through(centre);
    toHit.farthest = tracer.distance(rays, point) / glm::length(toHit.directionCentred);
    describeStructure(tracer, engine, toHit, probe);
    const trace::Structure structure = query.structures.chosen();
    const std::vector<trace::StructurePart> passed = engine.passed(toHit, kMostPassed);
    if (passed.empty()) return;
    probe.facts.push_back(probeCount("the eye ray passes", passed.size(), passedWord(structure)));
    // The tree of boxes is always there; its boxes are drawn only where another structure was chosen.
    if (structure != trace::Structure::bvh)
        probe.visited.push_back(passedShape(passed, structure, tracer.world().originWorld));
}

/// How much of the light's area the point sees, whether that is umbra, penumbra or full light, and what it receives: in closed
/// form, however the picture finds it. The light must have an area.
void describeArea(const Surfaces& surfaces, const trace::SurfacePoint& point, const dvec3& toViewerWorld, int light,
                  Probe& probe) {
    const trace::AreaVisibility area(surfaces.tracer(), light);
    const dvec3 normalWorld = surfaces.normalWorld(point, toViewerWorld);
    trace::AreaIrradiance found;
    area.irradiances({&point, 1}, {&normalWorld, 1}, {&found, 1});
    probe.find<SeenPoint>()->lightShare = found.visible;
    const std::string name = surfaces.scene().light(light).name;
    probe.facts.push_back(probeFact("share of the area of " + name + " that is seen", found.visible));
    probe.facts.push_back({"that is",
                           !surfaces.tracer().facesLight(point, light) ? "turned away"
                           : found.visible <= 0                        ? "umbra"
                           : found.visible >= 1                        ? "full light"
                                                                       : "penumbra",
                           ""});
    probe.facts.push_back(probeFact("irradiance", found.irradiance, "of pi times its radiance"));
    probe.facts.push_back(probeFact("without shadows", found.unshadowed, "of pi times its radiance"));
}

} // namespace

void describePixel(const PixelQuery& query, Probe& probe) {
    const Surfaces& surfaces = query.surfaces;
    const SamplingScene& sampling = query.sampling;
    const View& view = query.view;
    const trace::EyeRays rays = query.tracer.eyeRays(view.camera, view.size);
    const dvec2 centre = dvec2(query.pixel) + 0.5;
    const trace::SurfacePoint point = query.tracer.eyePoint(rays, centre);
    if (query.params.areMany())
        describeSamples(
            {surfaces, sampling.moving(), sampling.analytic(), view.camera, view.size, query.pixel, query.light},
            query.params.settings(query.tree, view.camera), point, probe);
    if (!point) return;
    describeTests(query, rays, point, probe);
    const dvec3 u = glm::normalize(rays.through(centre).directionCentred);
    if (query.asksArea) describeArea(surfaces, point, -u, query.light, probe);
    if (query.params.areMany())
        probe.facts.push_back({"the picture",
                               "the mean of " + std::to_string(query.params.pattern.count) +
                                   " such trees, spread by chance; this one goes through the middle of "
                                   "everything, at time 0",
                               ""});
    TreeSettings settings = query.tree;
    settings.skipsFaint = false; // all shadow rays are listed, also those that no picture would show
    RayTree tree;
    tree.trace({surfaces, sampling.atRest(), 0, nullptr, sampling.analytic()}, settings, rays.eyeCentred(), u, point,
               surfaces.mediaAround(rays.eyeCentred()));
    describeTree(tree, surfaces, query.light, probe);
}

} // namespace shadowlab::ray_tracing
