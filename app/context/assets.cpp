// SPDX-License-Identifier: MIT
#include "app/context/assets.h"

#include <cstdlib>

namespace shadowlab::context {

std::optional<std::filesystem::path> installedShare() {
    std::error_code failed;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failed);
    if (failed) return std::nullopt;
    std::filesystem::path share = program.parent_path().parent_path() / "share" / "shadowlab";
    if (!std::filesystem::is_directory(share / "assets", failed)) return std::nullopt;
    return share;
}

std::filesystem::path sourceTree() { return SHADOWLAB_SOURCE_DIR; }

std::filesystem::path assetsRoot() {
    if (const char* chosen = std::getenv("SHADOWLAB_ASSETS"); chosen && *chosen) return chosen;
    if (const auto share = installedShare()) return *share / "assets";
    return sourceTree() / "assets";
}

} // namespace shadowlab::context
