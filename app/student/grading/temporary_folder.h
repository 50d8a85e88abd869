// A folder for pictures of child processes, which goes with its object.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

namespace shadowlab::student {

class TemporaryFolder {
public:
    /// In the folder for temporary files. Throws Error (cannotWrite).
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// A folder in it; made where there is none.
    [[nodiscard]] std::filesystem::path folder(const std::string& name) const;

private:
    std::filesystem::path path_;
};

} // namespace shadowlab::student
