// Source beside pictures: every step's lines are where it says, in the files as they are.
// SPDX-License-Identifier: MIT
#include "techniques/source_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>

#include "techniques/foundation/base/error.h"
#include "techniques/registry.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab {
namespace {

std::vector<std::string> fileLines(const std::filesystem::path& path) {
    std::vector<std::string> lines;
    std::ifstream file(path);
    EXPECT_TRUE(file) << path;
    for (std::string line; std::getline(file, line);)
        lines.push_back(line);
    return lines;
}

struct Use {
    const TechniqueInfo* info;
    const PassInfo* pass;
    AnchorUse use;
};

std::vector<Use> allUses() {
    std::vector<Use> uses;
    for (const RegisteredTechnique& technique : registeredTechniques())
        for (const PassInfo& pass : technique.info->passes)
            for (const AnchorUse& use : anchorsOf(pass))
                uses.push_back({technique.info, &pass, use});
    return uses;
}

TEST(SourceTextTest, EveryAnchorOfEveryStepIsInTheFilesAndItsSnippetAreTheirLines) {
    const SourceText source = SourceText::read();
    const std::filesystem::path root = SHADOWLAB_SOURCE_DIR;
    std::size_t compared = 0;
    for (const Use& one : allUses()) {
        const Snippet& snippet = source.at(one.use.anchor);
        const std::vector<std::string> real = fileLines(root / snippet.file);
        const auto [first, last] = snippet.lines;
        ASSERT_TRUE(1 < first && first <= last && last <= static_cast<int>(real.size())) << one.use.anchor;
        EXPECT_NE(real[static_cast<std::size_t>(first) - 2].find("// [anchor: " + one.use.anchor + "]"),
                  std::string::npos)
            << one.use.anchor;
        for (int line = first; line <= last; ++line, ++compared)
            EXPECT_EQ(source.lines(snippet.file)[static_cast<std::size_t>(line) - 1],
                      real[static_cast<std::size_t>(line) - 1])
                << snippet.file << ":" << line;
        // More is no snippet but a file, and has no place beside a picture.
        EXPECT_LE(last - first, 45) << one.use.anchor;
    }
    EXPECT_GE(compared, 600u);
}

TEST(SourceTextTest, EveryStepOfTheLecturesHasSourceAndThoseOfOneTechniqueDiffer) {
    std::size_t steps = 0;
    for (const RegisteredTechnique& technique : registeredTechniques()) {
        const bool isInALecture = !technique.info->pseudocode.empty();
        std::set<std::string> formulas;
        for (const PassInfo& pass : technique.info->passes) {
            if (!isInALecture) continue;
            ++steps;
            EXPECT_FALSE(pass.anchors.empty()) << technique.info->id << " " << pass.id;
            EXPECT_TRUE(pass.formula.empty() || formulas.insert(std::string(pass.formula)).second)
                << technique.info->id << " " << pass.id;
        }
    }
    EXPECT_GE(steps, 40u);
}

TEST(SourceTextTest, NoAnchorStandsInTheSourceForNobody) {
    std::set<std::string> used;
    for (const Use& one : allUses())
        used.insert(one.use.anchor);
    std::set<std::string> found;
    const SourceText source = SourceText::read();
    for (const Snippet& snippet : source.snippets()) {
        EXPECT_TRUE(found.insert(snippet.anchor).second) << snippet.anchor << " twice";
        EXPECT_TRUE(used.contains(snippet.anchor)) << snippet.file << ": " << snippet.anchor;
    }
    EXPECT_EQ(found, used);
    EXPECT_GE(found.size(), 45u);
}

TEST(SourceTextTest, LinesThatOnlySometimesRunNameAParameterAndOneOfItsValues) {
    std::size_t checked = 0;
    for (const Use& one : allUses()) {
        if (one.use.parameter.empty()) continue;
        const std::unique_ptr<Technique> technique = one.info->make();
        const params::ParamList params = technique->params();
        const auto param = std::ranges::find(params, one.use.parameter, &params::Param::id);
        ASSERT_NE(param, params.end()) << one.use.parameter;
        const std::string range = "|" + params::rangeText(*param) + "|";
        EXPECT_NE(range.find("|" + one.use.value + "|"), std::string::npos) << one.use.value << " of " << range;
        ++checked;
    }
    EXPECT_GE(checked, 9u) << "the filters of the shadow map";
}

TEST(SourceTextTest, MarkedLinesOfPseudocodeAreThere) {
    int marked = 0;
    for (const RegisteredTechnique& technique : registeredTechniques()) {
        const auto lines = static_cast<int>(std::ranges::count(technique.info->pseudocode, '\n')) +
                           !technique.info->pseudocode.empty();
        for (const PassInfo& pass : technique.info->passes) {
            if (pass.pseudocodeLines.first == 0) continue;
            ++marked;
            EXPECT_LE(1, pass.pseudocodeLines.first) << technique.info->id << " " << pass.id;
            EXPECT_LE(pass.pseudocodeLines.first, pass.pseudocodeLines.last) << technique.info->id << " " << pass.id;
            EXPECT_LE(pass.pseudocodeLines.last, lines) << technique.info->id << " " << pass.id;
        }
    }
    EXPECT_GE(marked, 25);
}

TEST(SourceTextTest, ASnippetIsAParagraphOrAFunction) {
    SourceText source;
    source.add("made/up.cpp", "int a;\n"                     // 1
                              "// [anchor: function]\n"      // 2
                              "int f() {\n"                  // 3
                              "    int b = 1;\n"             // 4
                              "\n"                           // 5
                              "    // [anchor: paragraph]\n" // 6
                              "    g(b);\n"                  // 7
                              "    if (b)\n"                 // 8
                              "        h();\n"               // 9
                              "\n"                           // 10
                              "    return b;\n"              // 11
                              "}\n"                          // 12
                              "\n"                           // 13
                              "int j() {\n"                  // 14
                              "    // [anchor: inner]\n"     // 15
                              "    k();\n"                   // 16
                              "#ifdef LONG\n"                // 17
                              "    l();\n"                   // 18
                              "#endif\n"                     // 19
                              "}\n"                          // 20
                              "// [anchor: closed]\n"        // 21
                              "void n() {\n"                 // 22
                              "#ifdef LONG\n"                // 23
                              "    l();\n"                   // 24
                              "#endif\n"                     // 25
                              "}\n"                          // 26
                              "#else\n"                      // 27
                              "// [anchor: last]\n"          // 28
                              "m();");                       // 29, without an end
    const auto lines = [&](const char* anchor) {
        const LineRange range = source.at(anchor).lines;
        return std::pair(range.first, range.last);
    };
    EXPECT_EQ(lines("function"), std::pair(3, 12)) << "an empty line within it does not end it";
    EXPECT_EQ(lines("paragraph"), std::pair(7, 9));
    EXPECT_EQ(lines("inner"), std::pair(16, 19)) << "ended by the brace that closes what it is in";
    EXPECT_EQ(lines("closed"), std::pair(22, 26)) << "a directive belongs to it as long as its brace is open";
    EXPECT_EQ(lines("last"), std::pair(29, 29));
}

/// The message of the Error that `ask` throws.
std::string faultOf(const std::function<void()>& ask, ExitStatus status) {
    try {
        ask();
    } catch (const Error& fault) {
        EXPECT_EQ(fault.status(), status) << fault.what();
        return fault.what();
    }
    ADD_FAILURE() << "no fault";
    return "";
}

TEST(SourceTextTest, AnAnchorThatIsMissingDoubledOrEmptyIsAFault) {
    SourceText source;
    source.add("a.glsl", "// [anchor: twice]\nx;\n// [anchor: flatten]\ny;\n// [anchor: nothing]\n");
    source.add("b.glsl", "\n// [anchor: twice]\nz;\n");
    const auto ask = [&](const char* anchor) {
        return faultOf([&] { (void)source.at(anchor); }, ExitStatus::badInput);
    };
    EXPECT_EQ(ask("flattn"), "the source has no line `// [anchor: flattn]`; did you mean \"flatten\"?");
    EXPECT_EQ(ask("twice"), "b.glsl:2: the anchor 'twice' stands in a.glsl:1 as well; give one of them another name");
    EXPECT_EQ(ask("nothing"), "a.glsl: the anchor 'nothing' has no lines after it; put it right before them");
    PassInfo pass{"p", "", "", ""};
    pass.anchors = "good also[filter=pcf] bad[";
    faultOf([&] { (void)anchorsOf(pass); }, ExitStatus::bug);
}

TEST(SourceTextTest, ShadersAreReadFromTheFolderThatTheyAreCompiledFrom) {
    const scene::TempFolder folder;
    folder.write("planar/flatten.vert", "// saved a moment ago\n\n// [anchor: flatten]\nvoid main() {}\n");
    const std::string before = SourceText::read().lines("shaders/planar/flatten.vert")[0];
    ::setenv("SHADOWLAB_SHADERS", folder.path().c_str(), 1);
    const SourceText source = SourceText::read();
    ::unsetenv("SHADOWLAB_SHADERS");
    EXPECT_NE(before, "// saved a moment ago");
    EXPECT_EQ(source.lines("shaders/planar/flatten.vert")[0], "// saved a moment ago");
    EXPECT_EQ(source.at("flatten").lines.first, 4);
    EXPECT_EQ(source.at("extrude").file, "shaders/shadow_volume/extrude.vert") << "others are those that were built in";
}

} // namespace
} // namespace shadowlab
