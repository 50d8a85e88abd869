// SPDX-License-Identifier: MIT
#include "app/context/software.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace shadowlab::context {

namespace {
bool isDemanded = false;
}

void demandSoftware() {
    isDemanded = true;
    ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    // Which of Mesa's rasterisers: two draw two pictures. The user's own choice wins, and has to be one of the processor, too.
    ::setenv("GALLIUM_DRIVER", "llvmpipe", 0);
    // Beside another vendor's driver, which does not know these variables: windows take Mesa's.
    ::setenv("__GLX_VENDOR_LIBRARY_NAME", "mesa", 0);
}

bool isSoftwareDemanded() { return isDemanded; }

bool isSoftware(std::string_view renderer) {
    // Not "zink Vulkan 1.3(llvmpipe ...)": another driver on the way to the processor, and other pictures.
    constexpr std::array<std::string_view, 3> kNames{"llvmpipe", "softpipe", "Software Rasterizer"};
    return std::ranges::any_of(kNames, [&](std::string_view name) { return renderer.starts_with(name); });
}

} // namespace shadowlab::context
