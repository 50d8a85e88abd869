// SPDX-License-Identifier: MIT
#include "techniques/foundation/params/in_words.h"

#include <gtest/gtest.h>

namespace shadowlab::params {
namespace {

TEST(InWordsTest, OneOfAUnitIsSingular) {
    const auto said = [](const std::string& unit, const std::string& value) {
        int field = 1;
        return inWords(value, integer("count", field, 0, 100, unit, "Help."));
    };
    EXPECT_EQ(said("maps", "1"), "1 map");
    EXPECT_EQ(said("maps", "4"), "4 maps");
    EXPECT_EQ(said("maps", "0"), "0 maps");
    EXPECT_EQ(said("patches", "1"), "1 patch");
    EXPECT_EQ(said("m", "1"), "1 m");
    EXPECT_EQ(said("", "1"), "1");
}

enum class Filter { hard, pcf };

TEST(InWordsTest, ChoicesSayWhatTheyAre) {
    Filter field = Filter::hard;
    const Param filter = choice("filter", field, {"hard", {"pcf", "percentage-closer filtering"}}, "Help.");
    EXPECT_EQ(inWords("hard", filter), "hard");
    EXPECT_EQ(inWords("pcf", filter), "percentage-closer filtering");
    bool isOn = false;
    EXPECT_EQ(inWords("true", boolean("on", isOn, "Help.")), "on");
}

} // namespace
} // namespace shadowlab::params
