// SPDX-License-Identifier: MIT
#include "app/session/assets.h"

#include <cstdlib>

namespace shadowlab::session {

std::filesystem::path assetsRoot() {
    if (const char* chosen = std::getenv("SHADOWLAB_ASSETS"); chosen && *chosen) return chosen;
    return SHADOWLAB_SOURCE_ASSETS;
}

} // namespace shadowlab::session
