// Shaders with a fault, or an older way, in the place of the program's: what a test has to tell apart.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdlib>
#include <optional>
#include <string>

namespace shadowlab::testing {

/// Programs that are first used while it lives are made with the shaders in that folder below tests/. Without one: as ever.
class OtherShaders {
public:
    explicit OtherShaders(const std::string& folder) {
        if (const char* before = std::getenv(kVariable)) before_ = before;
        if (!folder.empty()) ::setenv(kVariable, (SHADOWLAB_SOURCE_DIR "/tests/" + folder).c_str(), 1);
    }
    ~OtherShaders() {
        if (before_)
            ::setenv(kVariable, before_->c_str(), 1);
        else
            ::unsetenv(kVariable);
    }
    OtherShaders(const OtherShaders&) = delete;
    OtherShaders& operator=(const OtherShaders&) = delete;

private:
    static constexpr const char* kVariable = "SHADOWLAB_SHADERS";
    std::optional<std::string> before_;
};

} // namespace shadowlab::testing
