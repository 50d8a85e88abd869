// What `probe` prints first: its verdict, and the sums that lead to it.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tests/cli/command_fixture.h"

namespace shadowlab::testing {
namespace {

using Json = nlohmann::json;

class ProbeVerdictTest : public CommandTest {};

// The first line is the verdict, below it stand the sums, indented, and after an empty line the details.
TEST_F(ProbeVerdictTest, TheVerdictComesFirst) {
    const std::vector<std::pair<std::string, std::string>> expected{
        {"shadow-volume-zpass", "FALSE SHADOW: entered 1, left 2"},
        {"shadow-volume", "LIT: entered 1, left 1"},
        {"ray-traced", "LIT: the shadow ray to sun arrives"}};
    for (const auto& [technique, verdict] : expected) {
        std::vector<std::string> words{"probe", "eye-in-shadow", "--pixel", "640,500", "-t", technique};
        const std::string text = succeed(words).out;
        EXPECT_EQ(text.substr(0, text.find('\n')), verdict);
        EXPECT_EQ(text.compare(text.find('\n') + 1, 2, "  "), 0) << text;
        EXPECT_LT(text.find("\n\n"), text.find("\nsurface "));
        words.emplace_back("--json");
        const Json json = Json::parse(succeed(words).out);
        EXPECT_EQ(json.at("verdict"), verdict);
        EXPECT_GE(json.at("sums").size(), 2u);
    }
}

} // namespace
} // namespace shadowlab::testing
