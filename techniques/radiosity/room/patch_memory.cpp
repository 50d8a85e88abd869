// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/patch_memory.h"

#include <algorithm>
#include <string>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/memory_estimate.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::radiosity {

void requireMemoryToSimplify(const scene::Scene& scene) {
    const std::uint64_t triangles = scene::triangleCount(scene);
    const std::uint64_t needed = scene.memory.takenBytes + triangles * kBytesPerTriangleSimplified;
    if (needed <= scene.memory.limitBytes) return;
    throw Error(ExitStatus::overLimit, "radiosity: scene " + scene::inQuotes(scene.name) + " has " +
                                           scene::counted(triangles, "triangle") + ", for which " +
                                           scene::beyondMemory(needed, scene.memory.limitBytes) +
                                           "; simplify it, or set --limit memory=VALUE");
}

void requireMemory(const scene::Scene& scene, std::size_t patches, std::uint64_t bytesPerPair) {
    // More than any machine can hold; its square still fits into 64 bits.
    const std::uint64_t counted = std::min<std::uint64_t>(patches, 400'000'000);
    const std::uint64_t needed = scene.memory.takenBytes + counted * counted * bytesPerPair;
    if (needed <= scene.memory.limitBytes) return;
    throw Error(ExitStatus::overLimit, "radiosity: scene " + scene::inQuotes(scene.name) + " makes " +
                                           std::to_string(patches) + " patches, for which " +
                                           scene::beyondMemory(needed, scene.memory.limitBytes) +
                                           "; choose fewer patches, remove objects, or set --limit memory=VALUE");
}

std::uint64_t bytesPerPair(SolverKind solver) {
    return solver == SolverKind::direct ? kBytesPerPairDirect : kBytesPerPair;
}

} // namespace shadowlab::radiosity
