// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/load/memory_estimate.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <set>
#include <thread>

#include <sys/resource.h>
#include <unistd.h>

#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/surface_color.h"

namespace shadowlab::scene {

namespace {

std::uint64_t leastLimit() {
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    const long pages = sysconf(_SC_PHYS_PAGES), pageBytes = sysconf(_SC_PAGESIZE);
    if (pages > 0 && pageBytes > 0) least = static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(pageBytes);
    rlimit addresses{};
    // Libraries and stacks reserve address space of which little is ever in memory, and Mesa crashes if it gets none.
    // Measured beyond the peak of memory, with a single store of memory (app/context/mesa.h): 253 MB on 2 cores,
    // 434 MB on 16.
    const std::uint64_t unused = 270'000'000 + 16'000'000 * std::uint64_t{std::thread::hardware_concurrency()};
    if (getrlimit(RLIMIT_AS, &addresses) == 0 && addresses.rlim_cur != RLIM_INFINITY)
        least =
            std::min<std::uint64_t>(least, addresses.rlim_cur - std::min<std::uint64_t>(addresses.rlim_cur, unused));
    std::uint64_t group = 0; // the limit of the control group (a container); "max" means no limit and fails to parse
    if (std::ifstream file("/sys/fs/cgroup/memory.max"); file >> group && group > 0) least = std::min(least, group);
    return least;
}

std::uint64_t texelsOf(ivec2 size) { return static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y); }

/// Bytes of the parts that have been loaded so far.
std::uint64_t memorySoFar(const Limits& limits) {
    return kBytesAtRest + limits.pictureBytes + limits.texels * kBytesPerTexel;
}

} // namespace

std::uint64_t memoryToUse() {
    static const std::uint64_t bytes = leastLimit() / 4 * 3;
    return bytes;
}

std::uint64_t memoryForTriangles(std::uint64_t triangles, const Limits& limits) {
    return memorySoFar(limits) + triangles * kBytesPerTriangle;
}

std::uint64_t memoryForMeshFile(std::uint64_t fileBytes, const Limits& limits) {
    return memorySoFar(limits) + fileBytes * kBytesPerMeshByte;
}

std::uint64_t memoryForMaterials(std::uint64_t materials, const Limits& limits) {
    return memorySoFar(limits) + materials * kBytesPerMaterial;
}

std::uint64_t memoryForImage(std::uint64_t texels, std::uint64_t fileBytes, const Limits& limits) {
    return memorySoFar(limits) + texels * kBytesPerTexelRead + fileBytes;
}

MemoryBudget memoryBudget(const Scene& scene, const Limits& limits) {
    Limits asLoaded = limits;
    std::set<const void*> counted;
    for (const Material& material : scene.materials) {
        if (const AlphaMask* mask = material.alphaMask.get(); mask && counted.insert(mask).second)
            asLoaded.texels += texelsOf(mask->size());
        if (const ColorImage* image = material.colorImage.get(); image && counted.insert(image).second)
            asLoaded.texels += texelsOf(image->size());
    }
    return {memoryForTriangles(triangleCount(scene), asLoaded), limits.memoryBytes};
}

std::string beyondMemory(std::uint64_t bytesNeeded, std::uint64_t limit) {
    const auto megabytes = [](std::uint64_t bytes) { return std::to_string((bytes + 999'999) / 1'000'000) + " MB"; };
    return "some " + megabytes(bytesNeeded) + " of memory are needed, more than the limit of " + megabytes(limit);
}

} // namespace shadowlab::scene
