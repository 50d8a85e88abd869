// SPDX-License-Identifier: MIT
#include "app/student/search/random_scenes.h"

namespace shadowlab::student {

std::span<const SceneKind> kindsOf(const Family& family) {
    if (family.id == "planar") return planarKinds();
    if (family.id == "shadow-map") return shadowMapKinds();
    if (family.id == "shadow-volume") return shadowVolumeKinds();
    return family.id == "ray-tracing" ? rayTracingKinds() : radiosityKinds();
}

const SceneKind& kindOf(const Family& family, int number) {
    const std::span<const SceneKind> kinds = kindsOf(family);
    return kinds[static_cast<std::size_t>(number) % kinds.size()];
}

SearchScene randomScene(const Family& family, std::uint64_t seed, int number) {
    Dice dice(seed, static_cast<std::uint64_t>(number));
    return tidied(kindOf(family, number).make(dice));
}

} // namespace shadowlab::student
