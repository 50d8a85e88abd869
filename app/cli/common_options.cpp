// SPDX-License-Identifier: MIT
#include "app/cli/common_options.h"

#include <algorithm>

#include "app/context/assets.h"
#include "app/picture/limits.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::cli {

void describeScene(DescribedOptions& add) {
    add.option("SCENE", "", "a built-in name (`list scenes`), a .json scene or an .obj mesh");
}

void describeBackend(DescribedOptions& add) {
    add.option("--backend", "BACKEND", "auto, egl, osmesa or window (default auto: the first that works)");
}

context::Backend backendFrom(const GivenOptions& given) {
    return context::backendFromName(given.text("--backend", "auto"));
}

scene::LoadOptions loadOptions(std::vector<std::filesystem::path> allowed) {
    return {.assetsRoot = context::assetsRoot(), .allowed = std::move(allowed), .limits = picture::limits()};
}

void requireDriverDraws(ivec2 size) {
    const int limit = context::largestSide();
    if (std::max(size.x, size.y) > limit)
        throw Error(ExitStatus::overLimit, "this OpenGL driver draws pictures of up to " + std::to_string(limit) +
                                               " pixels on a side; choose a smaller --size");
}

} // namespace shadowlab::cli
