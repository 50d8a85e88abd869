// SPDX-License-Identifier: MIT
#include "techniques/foundation/base/software.h"

#include <algorithm>
#include <array>

namespace shadowlab {

bool isSoftware(std::string_view renderer) {
    // "zink Vulkan 1.3(llvmpipe ...)" does not count: it draws through another driver, and differs in its pictures.
    constexpr std::array<std::string_view, 3> kNames{"llvmpipe", "softpipe", "Software Rasterizer"};
    return std::ranges::any_of(kNames, [&](std::string_view name) { return renderer.starts_with(name); });
}

} // namespace shadowlab
