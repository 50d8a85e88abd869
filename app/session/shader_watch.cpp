// SPDX-License-Identifier: MIT
#include "app/session/shader_watch.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "app/session/assets.h"
#include "techniques/foundation/gl/added_shaders.h"

namespace shadowlab::session {

ShaderWatch::ShaderWatch() {
    std::error_code ignored;
    if (const char* chosen = std::getenv("SHADOWLAB_SHADERS"); chosen && *chosen) {
        folder_ = chosen;
    } else if (!installedShare() && std::filesystem::is_directory(SHADOWLAB_SOURCE_SHADERS, ignored)) {
        folder_ = SHADOWLAB_SOURCE_SHADERS;
        // Only once a file in it is saved: until then the program shows what it was built with.
    }
    seen_ = newest();
}

bool ShaderWatch::changed() {
    constexpr auto kBetweenLooks = std::chrono::milliseconds(500);
    const auto now = std::chrono::steady_clock::now();
    if (now - looked_ < kBetweenLooks) return false;
    looked_ = now;
    const auto latest = newest();
    if (latest == seen_) return false;
    seen_ = latest;
    if (!folder_.empty()) ::setenv("SHADOWLAB_SHADERS", folder_.c_str(), 1);
    gl::readAddedShadersFromFolders();
    return true;
}

std::filesystem::file_time_type ShaderWatch::newest() const {
    auto latest = std::filesystem::file_time_type::min(); // zero is in the year 2174
    std::vector<std::filesystem::path> folders(gl::addedShaderFolders().begin(), gl::addedShaderFolders().end());
    if (!folder_.empty()) folders.push_back(folder_);
    for (const std::filesystem::path& folder : folders) {
        std::error_code failed;
        for (std::filesystem::recursive_directory_iterator file(folder, failed), end; !failed && file != end;
             file.increment(failed)) {
            std::error_code gone; // an editor may be replacing it just now
            const auto written = std::filesystem::last_write_time(file->path(), gone);
            if (!gone) latest = std::max(latest, written);
        }
    }
    return latest;
}

} // namespace shadowlab::session
