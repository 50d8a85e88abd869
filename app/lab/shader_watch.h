// Detects that a shader file was saved, so that it is compiled again while the program runs.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <utility>

namespace shadowlab::lab {

class ShaderWatch {
public:
    /// Watches the folder that SHADOWLAB_SHADERS names, else the sources' own where they are still there, which
    /// SHADOWLAB_SHADERS then names; and the folders that shaders of plug-ins were read from.
    ShaderWatch();
    /// Has anything changed since the last call? Looks at most twice a second.
    bool changed();

private:
    /// Of every file: its path, when it was written, and how long it is. A file that is deleted, or replaced by an older one,
    /// is a change, too.
    using Listing = std::map<std::filesystem::path, std::pair<std::filesystem::file_time_type, std::uintmax_t>>;
    [[nodiscard]] Listing listing() const;
    std::filesystem::path folder_;
    Listing seen_;
    std::chrono::steady_clock::time_point looked_{};
};

} // namespace shadowlab::lab
