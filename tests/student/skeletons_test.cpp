// Skeletons are the lecture's own source with blanks: filled in with the lines that were taken out, they are that source again.
// SPDX-License-Identifier: MIT
#include "app/student/skeletons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "app/context/assets.h"
#include "app/student/blanks.h"
#include "app/student/grading/families.h"
#include "app/student/lecture_files.h"
#include "techniques/foundation/base/error.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::student {
namespace {

Skeleton skeletonOf(const std::string& name) {
    return readSkeleton(context::assetsRoot() / "skeletons" / (name + ".json"));
}

std::vector<std::string> namesWithBlanks() {
    std::vector<std::string> names = skeletonNames();
    std::erase(names, "empty");
    return names;
}

std::vector<std::string> linesIn(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

/// Puts `code[n]` in the place of blank n + 1; numbers of those that were found are added.
std::string filledIn(const std::string& text, const std::vector<std::string>& code, std::set<int>& found) {
    std::string result;
    int open = 0;
    for (const std::string& line : linesIn(text)) {
        if (const std::size_t at = line.find("// === BLANK "); at != std::string::npos) {
            open = std::stoi(line.substr(at + 13));
            found.insert(open);
            result += code.at(static_cast<std::size_t>(open) - 1);
        }
        if (open == 0) result += line + "\n";
        if (line.find("// === END OF BLANK") != std::string::npos) open = 0;
    }
    return result;
}

TEST(SkeletonsTest, FilledInWithTheLecturesLinesTheyAreTheLecturesSource) {
    int blanks = 0;
    for (const std::string& name : namesWithBlanks()) {
        const Skeleton skeleton = skeletonOf(name);
        const SourceFiles whole = lectureFiles(skeleton.source);
        std::vector<std::string> code;
        for (const Blank& blank : skeleton.blanks) {
            const BlankedLines range = findLines(whole, blank);
            const std::vector<std::string> lines = linesIn(whole.at(range.file));
            code.emplace_back();
            for (std::size_t i = range.first; i <= range.last; ++i)
                code.back() += lines[i] + "\n";
        }
        SourceFiles files = whole;
        makeBlanks(files, skeleton.blanks);
        EXPECT_NE(files, whole) << name;
        std::set<int> found;
        for (auto& [file, text] : files) {
            text = filledIn(text, code, found);
            EXPECT_EQ(text, whole.at(file)) << name << ": " << file;
        }
        EXPECT_EQ(found.size(), skeleton.blanks.size()) << name;
        blanks += static_cast<int>(found.size());
    }
    EXPECT_GE(blanks, 25) << "five skeletons of four blanks or more";
}

// A folder of a student knows nothing of the program's own names: neither would it build, nor could it be loaded beside them.
TEST(SkeletonsTest, NothingOfTheLecturesNamesIsLeft) {
    std::size_t files = 0;
    for (const std::string& name : namesWithBlanks())
        for (const auto& [file, text] : skeletonFiles(name)) {
            ++files;
            for (const char* word :
                 {"techniques/lecture", "shaders/lecture", "shadowlab::lecture", "lecture-", "\"lecture/", "@"})
                EXPECT_EQ(text.find(word), std::string::npos) << name << ": " << file << " has " << word;
            if (file != "technique.cpp" && !file.starts_with("shaders/")) continue; // what the student reads
            for (const std::string& line : linesIn(text))
                EXPECT_LE(line.size(), 140u) << name << ": " << file << ": " << line;
        }
    EXPECT_GE(files, 30u) << "five skeletons: technique.cpp, words.h, CMakeLists.txt, README.md, and what they need";
}

TEST(SkeletonsTest, FilesAreThoseThatTheAlgorithmNeeds) {
    const auto namesOf = [](const std::string& skeleton) {
        std::vector<std::string> names;
        for (const auto& [file, text] : skeletonFiles(skeleton))
            names.push_back(file);
        return names;
    };
    EXPECT_EQ(namesOf("planar"),
              (std::vector<std::string>{"CMakeLists.txt", "README.md", "lit_scene.cpp", "lit_scene.h",
                                        "shaders/my_shadows/project.vert", "technique.cpp", "words.h"}));
    EXPECT_EQ(namesOf("radiosity"),
              (std::vector<std::string>{"CMakeLists.txt", "README.md", "patch_picture.cpp", "patch_picture.h",
                                        "patches.cpp", "patches.h", "rays.cpp", "rays.h",
                                        "shaders/my_shadows/patch.frag", "technique.cpp", "words.h"}));
}

TEST(SkeletonsTest, EachIsOfAFamilyThatIsGraded) {
    for (const std::string& name : namesWithBlanks())
        EXPECT_NO_THROW(findFamily(skeletonOf(name).family)) << name;
}

// A technique in a namespace of the program's would share its names.
TEST(SkeletonsTest, NoTechniqueIsNamedAsANamespaceOfTheProgram) {
    const std::regex declared(R"(^namespace shadowlab::(\w+))");
    std::set<std::string> spaces;
    for (const char* top : {"app", "techniques"})
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(std::filesystem::path(SHADOWLAB_SOURCE_DIR) / top)) {
            if (entry.path().extension() != ".h") continue;
            std::ifstream file(entry.path());
            std::smatch match;
            for (std::string line; std::getline(file, line);)
                if (std::regex_search(line, match, declared)) spaces.insert(match[1]);
        }
    EXPECT_GE(spaces.size(), 25u) << "rooms of app, the foundation's, and folders of techniques";
    for (std::string name : spaces) {
        std::ranges::replace(name, '_', '-');
        EXPECT_THROW(requireFreeName(name), Error) << name;
    }
    EXPECT_NO_THROW(requireFreeName("my-shadows"));
}

/// What is said of a description that does not fit the source.
std::string refusalOf(const std::string& blank) {
    const scene::TempFolder folder;
    const auto file = folder.write(
        "wrong.json",
        R"({"source": "planar", "family": "planar", "title": "T", "scene": "s", "blanks": [)" + blank + "\n]}");
    try {
        const Skeleton skeleton = readSkeleton(file);
        SourceFiles files = lectureFiles(skeleton.source);
        makeBlanks(files, skeleton.blanks);
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::badInput);
        return error.what();
    }
    return "nothing";
}

TEST(SkeletonsTest, WhatDoesNotFitTheSourceIsOneLineThatSaysWhere) {
    const auto blankOf = [](const std::string& anchor, const std::string& first, const std::string& last) {
        return R"({"anchor": ")" + anchor + R"(", "first": ")" + first + R"(", "last": ")" + last +
               R"(", "idea": "i", "explanation": ["e"], "whenRight": "w"})";
    };
    const std::string use = "program.use();", mark = "glStencilMask(kPlaneBit);";
    const struct {
        std::string blank, said;
    } cases[] = {
        {blankOf("projection-matrix", "return 1;", "}"), "'return 1;' stands 0 times in techniques/lecture/planar.cpp"},
        {blankOf("projection-draw", use, "return 2;"), "'return 2;' stands 0 times"},
        {blankOf("projection-plane", "}", "}"), "'}' stands "},
        {blankOf("projection-tag", mark, "glDepthFunc(GL_EQUAL);"), "its last line stands before its first one"},
        {blankOf("projection-matrx", use, use), "projection-matrix"},
        {blankOf("projection-draw", use, use) + ",\n" + blankOf("projection-draw", use, use),
         "shares lines of techniques/lecture/planar.cpp with blank 1"},
        {R"({"anchor": "projection-draw", "frist": "x"})", "frist"},
    };
    for (const auto& [blank, said] : cases) {
        const std::string refusal = refusalOf(blank);
        EXPECT_NE(refusal.find(said), std::string::npos) << refusal;
        EXPECT_NE(refusal.find("wrong.json:"), std::string::npos) << refusal;
        EXPECT_NE(refusal.find("; "), std::string::npos) << "a remedy: " << refusal;
        EXPECT_EQ(refusal.find('\n'), std::string::npos) << refusal;
    }
}

} // namespace
} // namespace shadowlab::student
