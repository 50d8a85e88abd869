// Parameters: values in and out as text, and what is refused with which words.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/params/param.h"

#include <gtest/gtest.h>

#include "techniques/foundation/base/error.h"

namespace shadowlab::params {
namespace {

enum class Filter { hard, pcf };
struct Params {
    bool on = true;
    int count = 3;
    double share = 0.1;
    Filter filter = Filter::pcf;
};
ParamList describe(Params& p) {
    return {boolean("on", p.on, "h"), integer("count", p.count, 1, 9, "texels", "h"),
            real("share", p.share, 0, 1, "", "h"), choice("filter", p.filter, {"hard", "pcf"}, "h")};
}

std::string refusal(const std::string& id, const std::string& text) {
    Params values;
    ParamList list = describe(values);
    try {
        setFromText(find(list, id, "t"), text, "t");
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::usage);
        EXPECT_EQ(values.count, 3);
        EXPECT_EQ(values.share, 0.1);
        return error.what();
    }
    return "accepted";
}

TEST(Param, ReadsAndWritesEveryKind) {
    Params values;
    ParamList list = describe(values);
    EXPECT_EQ(valueText(list[0]) + valueText(list[1]) + valueText(list[2]) + valueText(list[3]), "true30.1pcf");
    EXPECT_EQ(rangeText(list[0]) + rangeText(list[1]) + rangeText(list[2]) + rangeText(list[3]),
              "false|true1..90..1hard|pcf");
    setFromText(list[0], "false", "t");
    setFromText(list[1], "9", "t");
    setFromText(list[2], "2.5e-1", "t");
    setFromText(list[3], "hard", "t");
    EXPECT_FALSE(values.on);
    EXPECT_EQ(values.count, 9);
    EXPECT_EQ(values.share, 0.25);
    EXPECT_EQ(values.filter, Filter::hard);
    EXPECT_EQ(initialText(list[1]), "3");
}

TEST(Param, RefusesInsteadOfClamping) {
    EXPECT_EQ(refusal("count", "10"), "parameter 't.count': '10' is out of range; use 1..9 texels");
    EXPECT_EQ(refusal("count", "2.5"), "parameter 't.count': '2.5' is not a whole number; use 1..9 texels");
    EXPECT_EQ(refusal("count", "3x"), "parameter 't.count': '3x' is not a whole number; use 1..9 texels");
    EXPECT_EQ(refusal("share", "nan"), "parameter 't.share': 'nan' is not a number; use 0..1");
    EXPECT_EQ(refusal("share", "0,5"), "parameter 't.share': '0,5' is not a number; use 0..1");
    EXPECT_EQ(refusal("on", "yes"), "parameter 't.on': 'yes' is not one of its values; use one of false|true");
    EXPECT_EQ(refusal("filter", "PCF"), "parameter 't.filter': 'PCF' is not one of its values; use one of hard|pcf");
    EXPECT_EQ(refusal("cuont", "1"), "'t' has no parameter 'cuont'; did you mean \"count\"?");
}

TEST(Param, IsBasicWithoutAGroupAndNamedByItsId) {
    Params values;
    for (const Param& param : describe(values)) {
        EXPECT_TRUE(isBasic(param)) << param.id << " says nothing of groups: it is shown at once";
        EXPECT_EQ(choicesText(param), "");
    }
    EXPECT_EQ(labelOf(boolean("light-samples", values.on, "h")), "Light samples");
    EXPECT_EQ(labelOf(boolean({"c0", "c0, constant term"}, values.on, "h")), "c0, constant term");
}

TEST(Param, NamesOfChoicesStandBesideTheirIds) {
    Params values;
    const Param param = choice("filter", values.filter, {"hard", {"pcf", "percentage-closer filtering"}}, "h");
    EXPECT_EQ(rangeText(param), "hard|pcf");
    EXPECT_EQ(valueText(param), "pcf");
    EXPECT_EQ(choicesText(param), "pcf: percentage-closer filtering");
    int side = 8;
    const Param numbered = numberedChoice(
        "side", [&] { return side / 8 - 1; }, [&](int index) { side = 8 * (index + 1); }, {"8", "16"}, "h");
    numbered.set(1);
    EXPECT_EQ(side, 16);
    EXPECT_EQ(valueText(numbered) + initialText(numbered), "168");
    EXPECT_TRUE(isChanged(numbered));
}

TEST(Param, GroupsStandInTheirOrderAndExpertsLast) {
    Params values;
    const ParamList list = {inGroup(kExpert, boolean("a", values.on, "h")),
                            inGroup("Bias", boolean("b", values.on, "h")),
                            boolean("c", values.on, "h"),
                            inGroup(kTeachingSwitches, boolean("d", values.on, "h")),
                            inGroup("Filter", boolean("e", values.on, "h")),
                            inGroup("Bias", boolean("f", values.on, "h"))};
    std::string found;
    for (const ParamGroup& group : grouped(list)) {
        found += group.name + "(";
        for (const Param* param : group.params)
            found += param->id;
        found += ")";
    }
    EXPECT_EQ(found, "(c)Bias(bf)Filter(e)Teaching switches(d)Expert(a)");
    EXPECT_EQ(grouped({list[1]}).size(), 1u) << "no empty group of basic ones";
    EXPECT_TRUE(grouped({}).empty());
}

TEST(Param, HasAnEffectOnlyUnderAllItsConditions) {
    Params values;
    const ParamList list = describe(values);
    EXPECT_TRUE(hasEffect(list[0]));
    bool first = true, second = true;
    const Param both = onlyIf([&] { return first; }, onlyIf([&] { return second; }, list[0]));
    EXPECT_TRUE(hasEffect(both));
    first = false;
    EXPECT_FALSE(hasEffect(both));
    first = true;
    second = false;
    EXPECT_FALSE(hasEffect(both));
    EXPECT_TRUE(hasEffect(list[0]));
}

} // namespace
} // namespace shadowlab::params
