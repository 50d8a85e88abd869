// Feeds a target the files of its corpus, in any build: what has been found once does not come back.
// replay_TARGET FOLDER LEAST: 0 when at least so many files went well, and some of them were taken and some refused.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "tests/fuzz/target.h"

int main(int argc, char** argv) {
    using namespace shadowlab;
    if (argc != 3) return std::fprintf(stderr, "usage: %s FOLDER LEAST\n", argv[0]), 2;
    std::filesystem::path file;
    try {
        std::vector<std::filesystem::path> files;
        for (const auto& entry : std::filesystem::directory_iterator(argv[1]))
            files.push_back(entry.path());
        std::ranges::sort(files);
        std::size_t taken = 0;
        for (const std::filesystem::path& one : files) {
            file = one;
            std::ifstream stream(file, std::ios::binary);
            const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
            taken += fuzz::feed(bytes) == fuzz::Outcome::taken ? 1 : 0;
        }
        std::printf("%zu files: %zu taken, %zu refused\n", files.size(), taken, files.size() - taken);
        // A reader that takes all, or nothing, would not be tested by its corpus.
        const bool proves = files.size() >= std::strtoull(argv[2], nullptr, 10) && taken > 0 && taken < files.size();
        return proves ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", file.c_str(), error.what());
        return 1;
    }
}
