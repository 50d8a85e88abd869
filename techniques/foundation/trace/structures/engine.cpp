// What all engines share: making one by its name, and the parts of a structure that a ray passes.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/structures/engine.h"
#include "techniques/foundation/trace/structures/ray_volumes.h"

namespace shadowlab::trace {

std::vector<StructurePart> Engine::passed(const Ray& ray, std::size_t most) const {
    if (!isUsable(ray)) return {};
    const ShearedRay sheared(ray);
    const VolumeRay volumes(sheared);
    std::vector<StructurePart> passed;
    for (const StructurePart& part : parts(most)) {
        const double enter = part.isBall ? volumes.enter(Ball{part.centreCentred, part.radius}, sheared.farthest)
                                         : volumes.enter(Box{part.lowerCentred, part.upperCentred}, sheared.farthest);
        if (enter != kNowhere) passed.push_back(part);
    }
    return passed;
}

std::unique_ptr<Engine> makeEngine(Structure structure, const EngineInput& input) {
    switch (structure) {
    case Structure::none: return makeUnstructured(input);
    case Structure::objectSpheres: return makeObjectSpheres(input);
    case Structure::objectBoxes: return makeObjectBoxes(input);
    case Structure::groups: return makeGroups(input);
    case Structure::sphereTree: return makeSphereTree(input);
    case Structure::bvh: return makeBvhEngine(input);
    case Structure::grid: return makeGrid(input);
    case Structure::embree: return makeEmbreeEngine(input.triangles, true);
    }
    return nullptr;
}

} // namespace shadowlab::trace
