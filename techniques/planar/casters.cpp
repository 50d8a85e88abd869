// SPDX-License-Identifier: MIT
#include "techniques/planar/casters.h"

#include "techniques/foundation/scene/casters.h"
#include "techniques/foundation/scene/facing.h"

namespace shadowlab::planar {

bool Casters::buildNext(const scene::Snapshot& snapshot) {
    const scene::Revisions& now = snapshot->revisions;
    if (made_.geometry != now.geometry || made_.transforms != now.transforms || made_.lights != now.lights) {
        perLight_.clear();
        made_ = now;
    }
    if (perLight_.size() == snapshot->lights.size()) return true;

    std::vector<Caster> casters;
    for (const std::size_t o : scene::allCasters(*snapshot)) {
        const scene::Object& object = snapshot->objects[o];
        Caster caster{o, dvec3(0.0), {}};
        for (const vec3& position : object.mesh->positionsMesh)
            caster.farthestMesh = glm::max(caster.farthestMesh, dvec3(glm::abs(position)));
        const std::vector<std::int8_t> facing = scene::facingSigns(object, snapshot->lights[perLight_.size()]);
        std::vector<std::uint32_t> blocking;
        for (std::uint32_t t = 0; t < facing.size(); ++t)
            if (facing[t] != 0) blocking.push_back(t);
        caster.blocking = runsOf(blocking);
        casters.push_back(std::move(caster));
    }
    perLight_.push_back(std::move(casters));
    return perLight_.size() == snapshot->lights.size();
}

} // namespace shadowlab::planar
