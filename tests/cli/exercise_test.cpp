// `exercise` as a user meets it: what it writes, the same bytes for the same seed, and refusals.
// SPDX-License-Identifier: MIT
#include "tests/cli/command_fixture.h"

namespace shadowlab::testing {
namespace {

class ExerciseTest : public CommandTest {
protected:
    [[nodiscard]] std::string content(const std::string& name) const {
        return fileContent(folder.path() / name);
    }
};

TEST_F(ExerciseTest, WritesASheetAndItsKey) {
    const ProgramResult result = succeed({"exercise", "--seed", "7", "-o", "one"});
    EXPECT_NE(result.out.find("one/sheet.html"), std::string::npos) << result.shown();
    succeed({"exercise", "--seed", "7", "-o", "two", "--key", "elsewhere.html"});
    EXPECT_EQ(content("one/sheet.html"), content("two/sheet.html"));
    EXPECT_EQ(content("one/key.html"), content("elsewhere.html"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "two/key.html"));
    succeed({"exercise", "--seed", "8", "-o", "three"});
    EXPECT_NE(content("one/sheet.html"), content("three/sheet.html"));
    EXPECT_NE(content("one/sheet.html").find("<h2>8. "), std::string::npos) << "eight exercises";
    EXPECT_EQ(content("one/sheet.html").find("<h2>9. "), std::string::npos);
    EXPECT_NE(content("one/key.html").find("Usual mistake"), std::string::npos);
    EXPECT_EQ(content("one/sheet.html").find("Usual mistake"), std::string::npos);
}

TEST_F(ExerciseTest, KindsAndPaperAreChosen) {
    succeed({"exercise", "--kind", "counts,texel", "--kind", "tree", "--questions", "3", "--paper", "letter", "-o", "some"});
    const std::string sheet = content("some/sheet.html");
    for (const char* word : {"counting faces", "the texel", "the size of a tree", "size: letter"})
        EXPECT_NE(sheet.find(word), std::string::npos) << word;
    EXPECT_EQ(sheet.find("<h2>4. "), std::string::npos);
}

TEST_F(ExerciseTest, Refusals) {
    expectRefused({"exercise", "--seed", "7"}, 2, {"-o"});
    expectRefused({"exercise", "--seed", "0", "-o", "x"}, 2, {"--seed"});
    expectRefused({"exercise", "--questions", "49", "-o", "x"}, 2, {"--questions", "48"});
    expectRefused({"exercise", "--kind", "texels", "-o", "x"}, 2, {"texels", "texel"});
    expectRefused({"exercise", "--paper", "a5", "-o", "x"}, 2, {"--paper", "a4"});
    expectRefused({"exercise", "--key", "key.pdf", "-o", "x"}, 2, {"--key", ".html"});
    folder.write("there", "a file");
    expectRefused({"exercise", "-o", "there"}, 4, {"there"});
    expectRefused({"exercise", "-o", "x", "--key", "no/such/key.html"}, 4, {"no/such"});
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "x"));
}

} // namespace
} // namespace shadowlab::testing
