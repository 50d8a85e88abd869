// SPDX-License-Identifier: MIT
#include "tests/fuzz/target.h"

#include <cstdlib>
#include <fstream>

#include "techniques/foundation/base/error.h"

namespace shadowlab::fuzz {

namespace {

struct Folder {
    std::filesystem::path path;
    Folder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "shadowlab_fuzz_XXXXXX").string();
        if (!::mkdtemp(pattern.data())) throw std::runtime_error("no folder for temporary files can be made");
        path = std::filesystem::canonical(pattern);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
};

} // namespace

Outcome outcomeOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        const std::string message = error.what();
        require(message.find("; ") != std::string::npos, "a message without a remedy: " + message);
        using enum ExitStatus;
        require(error.status() == usage || error.status() == badInput || error.status() == overLimit,
                "a message that does not blame the input: " + message);
        return Outcome::refused;
    }
    return Outcome::taken;
}

const std::filesystem::path& ownFolder() {
    static const Folder folder;
    return folder.path;
}

std::filesystem::path written(const char* name, std::string_view bytes) {
    std::filesystem::path file = ownFolder() / name;
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!stream.flush()) throw std::runtime_error("a temporary file cannot be written");
    return file;
}

} // namespace shadowlab::fuzz
