// A folder with a small scene, the program run inside it, and what must hold after every run.
// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "techniques/foundation/image/png/png.h"
#include "tests/foundation/scene/scene_files.h"
#include "tests/support/run_program.h"

namespace shadowlab::testing {

inline std::string fileContent(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline image::DecodedPng decoded(const std::string& png) {
    return image::decodePng({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()}, "picture");
}

/// What a picture's header says, read from the bytes themselves.
struct PngHeader {
    std::uint32_t width = 0, height = 0;
    int bitDepth = 0, colorType = 0; ///< 2: RGB, 4: grey and alpha
};
inline PngHeader headerOf(const std::string& png) {
    if (png.size() < 33 || png.compare(1, 3, "PNG") != 0) return {};
    const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(png[i])); };
    const auto number = [&](std::size_t i) {
        return byte(i) << 24 | byte(i + 1) << 16 | byte(i + 2) << 8 | byte(i + 3);
    };
    return {number(16), number(20), static_cast<int>(byte(24)), static_cast<int>(byte(25))};
}

// The eye looks at the side of the box on which its shadows fall.
constexpr const char* kCamera = R"("camera": {"position": [-3, 2.5, 4], "target": [0, 0.5, 0]})";
constexpr const char* kTwoLights =
    R"("lights": [{"name": "key", "type": "point", "position": [2, 5, 3], "intensity": 40},
                  {"name": "sun", "type": "directional", "direction": [-0.3, -1, -0.2]}])";
constexpr const char* kBoxOnFloor =
    R"("objects": [{"shape": "quad", "size": [12, 12]}, {"shape": "box", "size": [1, 1, 1], "translate": [0, 0.5, 0]}])";

inline std::string sceneText(const std::string& camera, const std::string& lights, const std::string& objects) {
    return "{" + camera + ", \"ambient\": [0.05, 0.05, 0.05],\n" + lights + ",\n" + objects + "}\n";
}

class CommandTest : public ::testing::Test {
protected:
    CommandTest() { folder.write("box.json", sceneText(kCamera, kTwoLights, kBoxOnFloor)); }

    /// Files of the test's folder with their content; folders and special files with none.
    using Listing = std::map<std::string, std::string>;
    [[nodiscard]] Listing listing() const {
        Listing files;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
            files[entry.path().lexically_relative(folder.path()).string()] =
                entry.is_regular_file() ? fileContent(entry.path()) : "";
        return files;
    }

    /// Names that were not there `before`.
    [[nodiscard]] std::vector<std::string> newSince(const Listing& before) const {
        std::vector<std::string> names;
        for (const auto& [name, content] : listing())
            if (!before.contains(name)) names.push_back(name);
        return names;
    }

    ProgramResult run(const std::vector<std::string>& arguments, ProgramSetting setting = {}) const {
        std::vector<std::string> argv{SHADOWLAB_PROGRAM};
        argv.insert(argv.end(), arguments.begin(), arguments.end());
        setting.folder = folder.path();
        return runProgram(argv, setting);
    }

    /// A line of a shell, in which $SHADOWLAB is the program.
    ProgramResult shell(const std::string& line, ProgramSetting setting = {}) const {
        setting.folder = folder.path();
        setting.environment["SHADOWLAB"] = SHADOWLAB_PROGRAM;
        return runProgram({"/bin/sh", "-c", line}, setting);
    }

    ProgramResult succeed(const std::vector<std::string>& arguments, const ProgramSetting& setting = {}) const {
        ProgramResult result = run(arguments, setting);
        EXPECT_EQ(result.status, 0) << result.shown();
        return result;
    }

    /// Runs, and expects: this status, one line that begins `shadowlab: ` and says all of `parts`, nothing on standard
    /// output, and the folder as it was.
    void expectRefused(const std::vector<std::string>& arguments, int status, const std::vector<std::string>& parts,
                       const ProgramSetting& setting = {}) const {
        const Listing before = listing();
        const ProgramResult result = run(arguments, setting);
        expectOneLine(result, status, parts);
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(listing(), before);
    }

    static void expectOneLine(const ProgramResult& result, int status, const std::vector<std::string>& parts) {
        EXPECT_EQ(result.status, status) << result.shown();
        EXPECT_EQ(result.err.substr(0, 11), "shadowlab: ") << result.shown();
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.shown();
        EXPECT_FALSE(result.err.empty() || result.err.back() != '\n') << result.shown();
        EXPECT_NE(result.err.find("; "), std::string::npos) << "no remedy: " << result.err;
        for (const std::string& part : parts)
            EXPECT_NE(result.err.find(part), std::string::npos) << "not said: " << part << "\n" << result.shown();
    }

    scene::TempFolder folder;
};

} // namespace shadowlab::testing
