// `demo` where there is no display: it writes what the window would have shown.
// SPDX-License-Identifier: MIT
#include "tests/cli/command_fixture.h"

namespace shadowlab::testing {
namespace {

using Words = std::vector<std::string>;

class DemoTest : public CommandTest {};

TEST_F(DemoTest, WritesItsPictureAndSaysWhere) {
    const Listing before = listing();
    // Short for `demo box.json`; without a display there is no window.
    const ProgramResult result = succeed({"box.json"}, {.environment = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}});
    EXPECT_EQ(newSince(before), Words{"box-comparison.png"});
    EXPECT_EQ(result.out, (folder.path() / "box-comparison.png").string() + "\n");
    EXPECT_EQ(headerOf(fileContent(folder.path() / "box-comparison.png")).width, 1600u);
}

} // namespace
} // namespace shadowlab::testing
