// SPDX-License-Identifier: MIT
#include "app/course/page_code.h"

#include "techniques/foundation/scene/load/file_access.h"

namespace shadowlab::course {

std::string pageCode(const std::filesystem::path& assets, std::span<const char* const> files) {
    constexpr std::uint64_t kLargestFile = 1 << 20; // bytes; ours have some ten thousand
    std::string code;
    for (const char* file : files)
        code += scene::readFile(assets / "pages" / file, kLargestFile);
    return code;
}

} // namespace shadowlab::course
