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
    // Which of Mesa's software rasterisers: they differ in their pictures. A choice of the user's takes precedence; it has to be a software
    // rasteriser, too (context.cpp).
    ::setenv("GALLIUM_DRIVER", "llvmpipe", 0);
    // Another vendor's GLX ignores these variables, so windows have to take Mesa's.
    ::setenv("__GLX_VENDOR_LIBRARY_NAME", "mesa", 0);
}

bool isSoftwareDemanded() { return isDemanded; }

bool isSoftware(std::string_view renderer) {
    // "zink Vulkan 1.3(llvmpipe ...)" does not count: it draws through another driver, and differs in its pictures.
    constexpr std::array<std::string_view, 3> kNames{"llvmpipe", "softpipe", "Software Rasterizer"};
    return std::ranges::any_of(kNames, [&](std::string_view name) { return renderer.starts_with(name); });
}

} // namespace shadowlab::context
