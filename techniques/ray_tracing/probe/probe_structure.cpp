// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/probe/pixel_probe.h"

#include <algorithm>

#include "techniques/foundation/trace/structures/ray_volumes.h"
#include "techniques/probed/structure_probe.h"
#include "techniques/ray_tracing/structures/structure_shapes.h"

namespace shadowlab::ray_tracing {

namespace {

// The most volumes of one level of a tree that are listed; more could not be read in a drawing.
constexpr std::size_t kMostVolumes = 64;

std::string objectOf(const trace::SceneTracer& tracer, std::uint32_t primitive) {
    return tracer.scene().objects[tracer.world().objects[primitive]].name;
}

StructureProbe::Cell cellOf(const trace::SceneTracer& tracer, const trace::StructureCells& grid,
                            const trace::StructurePart& part) {
    const dvec3 cellSize = (grid.upperCentred - grid.lowerCentred) / dvec3(grid.counts);
    StructureProbe::Cell cell;
    cell.at = glm::ivec3(glm::round((part.lowerCentred - grid.lowerCentred) / cellSize));
    cell.lowerWorld = tracer.world().originWorld + part.lowerCentred;
    cell.upperWorld = tracer.world().originWorld + part.upperCentred;
    for (const std::uint32_t primitive : part.primitives) {
        const std::string name = objectOf(tracer, primitive);
        if (std::ranges::find(cell.objects, name) == cell.objects.end()) cell.objects.push_back(name);
    }
    return cell;
}

} // namespace

void describeStructure(const trace::SceneTracer& tracer, const trace::Engine& engine, const trace::Ray& toHit,
                       Probe& probe) {
    const dvec3& originWorld = tracer.world().originWorld;
    StructureProbe found;
    if (const auto grid = engine.cells()) {
        found.lowerWorld = originWorld + grid->lowerCentred;
        found.upperWorld = originWorld + grid->upperCentred;
        found.counts = grid->counts;
        for (const trace::StructurePart& part : engine.passed(toHit, kMostPassed))
            found.cells.push_back(cellOf(tracer, *grid, part));
        probe.add(std::move(found));
        return;
    }
    const trace::ShearedRay sheared(toHit);
    const trace::VolumeRay ray(sheared);
    for (const trace::StructurePart& part : engine.parts(kMostVolumes)) {
        StructureProbe::Volume volume;
        volume.level = part.level;
        volume.parent = part.parent;
        volume.isBall = part.isBall;
        volume.radius = part.radius;
        volume.lowerWorld = originWorld + (part.isBall ? part.centreCentred - part.radius : part.lowerCentred);
        volume.upperWorld = originWorld + (part.isBall ? part.centreCentred + part.radius : part.upperCentred);
        if (!part.primitives.empty()) volume.object = objectOf(tracer, part.primitives.front());
        const double enter = part.isBall
                                 ? ray.enter(trace::Ball{part.centreCentred, part.radius}, sheared.farthest)
                                 : ray.enter(trace::Box{part.lowerCentred, part.upperCentred}, sheared.farthest);
        const auto parent = static_cast<std::size_t>(std::max(part.parent, 0));
        volume.isAsked = part.parent < 0 || (found.volumes[parent].isAsked && found.volumes[parent].isEntered);
        volume.isEntered = enter != trace::kNowhere;
        found.volumes.push_back(std::move(volume));
    }
    if (!found.volumes.empty()) probe.add(std::move(found));
}

} // namespace shadowlab::ray_tracing
