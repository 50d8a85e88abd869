// SPDX-License-Identifier: MIT
#include "app/cli/same_file.h"

#include <system_error>

#include "techniques/foundation/image/output_file.h"

namespace shadowlab::cli {

bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code ignored;
    if (std::filesystem::exists(a, ignored) && !std::filesystem::is_regular_file(a, ignored)) return false;
    return std::filesystem::equivalent(a, b, ignored) || image::outputTarget(a) == image::outputTarget(b);
}

} // namespace shadowlab::cli
