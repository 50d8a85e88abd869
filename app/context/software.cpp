// SPDX-License-Identifier: MIT
#include "app/context/software.h"

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

} // namespace shadowlab::context
