// SPDX-License-Identifier: MIT
#include "app/lab/shader_watch.h"

#include <cstdlib>
#include <vector>

#include "app/context/assets.h"
#include "techniques/foundation/gl/shader_source.h"

namespace shadowlab::lab {

ShaderWatch::ShaderWatch() {
    std::error_code ignored;
    if (const char* chosen = std::getenv("SHADOWLAB_SHADERS"); chosen && *chosen) {
        folder_ = chosen;
    } else if (!context::installedShare() && std::filesystem::is_directory(context::sourceTree() / "shaders", ignored)) {
        folder_ = context::sourceTree() / "shaders";
        // Only once a file in it is saved: until then the program shows what it was built with.
    }
    seen_ = listing();
}

bool ShaderWatch::changed() {
    constexpr auto kBetweenLooks = std::chrono::milliseconds(500);
    const auto now = std::chrono::steady_clock::now();
    if (now - looked_ < kBetweenLooks) return false;
    looked_ = now;
    Listing latest = listing();
    if (latest == seen_) return false;
    seen_ = std::move(latest);
    if (!folder_.empty()) ::setenv("SHADOWLAB_SHADERS", folder_.c_str(), 1);
    gl::readAddedShadersFromFolders();
    return true;
}

ShaderWatch::Listing ShaderWatch::listing() const {
    Listing files;
    std::vector<std::filesystem::path> folders(gl::addedShaderFolders().begin(), gl::addedShaderFolders().end());
    if (!folder_.empty()) folders.push_back(folder_);
    for (const std::filesystem::path& folder : folders) {
        std::error_code failed;
        for (std::filesystem::recursive_directory_iterator file(folder, failed), end; !failed && file != end;
             file.increment(failed)) {
            std::error_code gone; // an editor may be replacing it just now
            const auto written = std::filesystem::last_write_time(file->path(), gone);
            if (gone) continue;
            const std::uintmax_t size = std::filesystem::is_regular_file(file->path(), gone)
                                            ? std::filesystem::file_size(file->path(), gone)
                                            : 0; // no file: another size than any shader has
            files[file->path()] = {written, size};
        }
    }
    return files;
}

} // namespace shadowlab::lab
