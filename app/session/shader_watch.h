// Notices that a shader file was saved, so that it is compiled while the picture runs.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <filesystem>

namespace shadowlab::session {

class ShaderWatch {
public:
    /// Watches the folder that SHADOWLAB_SHADERS names, else the sources' own where they are still there, which
    /// SHADOWLAB_SHADERS then names; and the folders that shaders of plug-ins were read from.
    ShaderWatch();
    /// Has anything changed since the last call? Looks at most twice a second.
    bool changed();

private:
    [[nodiscard]] std::filesystem::file_time_type newest() const;
    std::filesystem::path folder_;
    std::filesystem::file_time_type seen_{};
    std::chrono::steady_clock::time_point looked_{};
};

} // namespace shadowlab::session
