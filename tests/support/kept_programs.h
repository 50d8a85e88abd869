// The programs that tests link, as files for another compiler to look at (tests/shaders/glsl_check.py).
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <unistd.h>

namespace shadowlab::testing {

/// Writes the two stages of a program into the folder that SHADOWLAB_KEEP_PROGRAMS names, if it names one. The name is made from
/// what they say: a program that many tests link is kept once.
inline void keepProgram(const std::string& vertex, const std::string& fragment) {
    const char* const folder = std::getenv("SHADOWLAB_KEEP_PROGRAMS");
    if (!folder || !*folder) return;
    const std::string name = std::to_string(std::hash<std::string>{}(vertex + '\0' + fragment));
    for (const auto& [ending, text] : {std::pair{".vert", &vertex}, std::pair{".frag", &fragment}}) {
        const std::filesystem::path path = std::filesystem::path(folder) / (name + ending);
        if (std::filesystem::exists(path)) continue;
        // Under a name of its own first: tests in other processes keep the same program at the same time.
        const std::filesystem::path unfinished = path.string() + "." + std::to_string(::getpid());
        std::filesystem::create_directories(folder);
        std::ofstream file(unfinished);
        file << *text;
        file.close();
        if (!file) throw std::runtime_error(unfinished.string() + ": cannot be written; choose another folder");
        std::filesystem::rename(unfinished, path);
    }
}

} // namespace shadowlab::testing
