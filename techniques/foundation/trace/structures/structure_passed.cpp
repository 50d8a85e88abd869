// Which parts of a structure lie on a ray's way.
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

} // namespace shadowlab::trace
