// SPDX-License-Identifier: MIT
#include "app/student/plugin_file.h"

#include <algorithm>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/plugin.h"

namespace shadowlab::student {

namespace {

// A plug-in with all its debugging information has some 3 million bytes.
constexpr std::uintmax_t kLargestFile = 256u << 20;

constexpr std::size_t kDigits = 16;

bool isDigits(std::string_view text) {
    return text.size() == kDigits &&
           std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

/// The digits after the mark; empty where there is no mark.
std::string contractIn(std::string_view bytes) {
    for (std::size_t at = bytes.find(kContractMark); at != std::string_view::npos;
         at = bytes.find(kContractMark, at + 1)) {
        const std::string_view digits = bytes.substr(at + kContractMark.size()).substr(0, kDigits);
        if (isDigits(digits)) return std::string(digits);
    }
    return {};
}

} // namespace

void refusePlugin(const std::filesystem::path& file, const std::string& whatAndMend) {
    throw Error(ExitStatus::badInput, file.string() + ": " + whatAndMend);
}

void requirePluginFile(const std::filesystem::path& file) {
    for (const std::string_view word : {"$ORIGIN", "${ORIGIN}", "$LIB", "${LIB}", "$PLATFORM", "${PLATFORM}"})
        if (file.native().find(word) != std::string::npos)
            refusePlugin(file, std::string(word) + " stands for something else where libraries are loaded; rename it");
    std::error_code failed;
    const auto status = std::filesystem::status(file, failed);
    if (!std::filesystem::exists(status))
        refusePlugin(file, "there is no such file; build the plug-in, and name the .so that was made");
    if (!std::filesystem::is_regular_file(status))
        refusePlugin(file, "a plug-in is a file; name the .so that was built");
    if (const auto size = std::filesystem::file_size(file, failed); failed || size > kLargestFile)
        refusePlugin(file, "the file is larger than 256 MiB, which no plug-in is; name the .so that was built");
    if (const std::string why = scene::whyUnreadable(file); !why.empty())
        refusePlugin(file, why + "; fix its permissions");
    const std::string bytes = scene::readFile(file, kLargestFile);
    image::keepInput(file);
    constexpr std::string_view kElf = "\x7f"
                                      "ELF";
    if (!bytes.starts_with(kElf))
        refusePlugin(file, "this is no shared library; name the .so that was built, not its source");
    const std::string contract = contractIn(bytes);
    if (contract.empty())
        refusePlugin(file, "this library is no plug-in of shadowlab; build it with shadowlab_plugin() in its "
                           "CMakeLists.txt (`shadowlab new-technique NAME` writes one)");
    if (contract != contractOfProgram())
        refusePlugin(file, "it was built for another version of shadowlab (contract " + contract +
                               ", this program has " + std::string(contractOfProgram()) +
                               "); build it again with the headers of this one");
}

} // namespace shadowlab::student
