// The parameters of all techniques: few basic ones, the others in groups, all of them in words.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <set>

#include <gtest/gtest.h>

#include "techniques/foundation/params/param.h"
#include "techniques/registry.h"

namespace shadowlab {
namespace {

/// As many settings as a class can take in at once.
constexpr int kMostBasic = 5;
/// All that the program had when this was written: fewer would be a loss.
constexpr std::size_t kLeastParameters = 130;

/// Calls `check` for each technique with its parameters; returns how many parameters there were.
std::size_t forEachTechnique(const std::function<void(const TechniqueInfo&, params::ParamList&)>& check) {
    std::size_t parameters = 0;
    for (const RegisteredTechnique& technique : registeredTechniques()) {
        const std::unique_ptr<Technique> instance = technique.info->make();
        params::ParamList list = instance->params();
        parameters += list.size();
        SCOPED_TRACE(technique.info->id);
        check(*technique.info, list);
    }
    return parameters;
}

/// Sets the parameters from `next` on to each of their choices, or to both ends of their range, and calls `check` for every combination.
void forEachSetting(const std::vector<params::Param*>& list, std::size_t next, const std::function<void()>& check) {
    if (next == list.size()) return check();
    params::Param& param = *list[next];
    const bool isNumber = param.kind == params::Kind::integer || param.kind == params::Kind::real;
    const double step = isNumber ? param.maximum - param.minimum : 1;
    for (double value = param.minimum; value <= param.maximum; value += step) {
        param.set(value);
        forEachSetting(list, next + 1, check);
    }
    param.set(param.initial);
}

TEST(ParametersTest, AtMostFiveBasicOnesHaveAnEffectAtOnce) {
    int settings = 0;
    const std::size_t parameters = forEachTechnique([&](const TechniqueInfo&, params::ParamList& list) {
        std::vector<params::Param*> basic;
        for (params::Param& param : list)
            if (params::isBasic(param)) basic.push_back(&param);
        EXPECT_EQ(basic.empty(), list.empty()) << "a technique with parameters has some that are always shown";
        int most = 0;
        forEachSetting(basic, 0, [&] {
            ++settings;
            most = std::max(most, static_cast<int>(std::ranges::count_if(
                                      basic, [](const params::Param* param) { return params::hasEffect(*param); })));
        });
        EXPECT_LE(most, kMostBasic);
    });
    EXPECT_GE(parameters, kLeastParameters);
    EXPECT_GE(settings, 1000) << "the shadow map alone has 9 filters x 7 biases, with two resolutions and radii";
}

TEST(ParametersTest, LabelsAndNamesAreUniqueWords) {
    const std::size_t parameters = forEachTechnique([](const TechniqueInfo&, const params::ParamList& list) {
        std::set<std::string> labels;
        for (const params::Param& param : list) {
            const std::string label = params::labelOf(param);
            EXPECT_TRUE(labels.insert(label).second) << label << " twice";
            EXPECT_LE(label.size(), 36u) << label << ": it has to fit in a line of the panel";
            EXPECT_EQ(param.help.find('\n'), std::string::npos) << param.id;
            EXPECT_TRUE(param.help.ends_with('.')) << param.id << ": " << param.help;
            EXPECT_TRUE(param.choiceNames.empty() || param.choiceNames.size() == param.choices.size()) << param.id;
            std::set<std::string> names;
            for (std::size_t i = 0; i < param.choiceNames.size(); ++i) {
                const std::string& name = param.choiceNames[i];
                EXPECT_TRUE(names.insert(name.empty() ? param.choices[i] : name).second) << name << " twice";
                EXPECT_LE(name.size(), 32u) << name << ": it has to fit in the panel's box";
                EXPECT_EQ(name.find_first_of(":;"), std::string::npos) << name << ": choicesText() separates by them";
            }
        }
    });
    EXPECT_GE(parameters, kLeastParameters);
}

/// Ids of choices that are words of the field themselves; every other one has a name beside it.
bool isPlainWord(const std::string& id) {
    static const std::set<std::string> kWords{"none",   "lit",     "infinity",   "texels",   "metres",      "jittered",
                                              "random", "regular", "watertight", "hemicube", "interpolated"};
    const bool isNumber = std::ranges::all_of(id, [](char c) { return c >= '0' && c <= '9'; });
    return isNumber || kWords.contains(id);
}

TEST(ParametersTest, AbbreviatedChoicesSayWhatTheyAre) {
    std::size_t named = 0;
    forEachTechnique([&](const TechniqueInfo&, const params::ParamList& list) {
        for (const params::Param& param : list)
            for (std::size_t i = 0; param.kind == params::Kind::choice && i < param.choices.size(); ++i) {
                named += !param.choiceNames[i].empty();
                EXPECT_TRUE(!param.choiceNames[i].empty() || isPlainWord(param.choices[i]))
                    << param.id << "=" << param.choices[i] << " needs a name";
            }
    });
    EXPECT_GE(named, 70u);
}

TEST(ParametersTest, SwitchesForTeachingAndForExpertsStandLast) {
    std::size_t groups = 0;
    const std::size_t parameters = forEachTechnique([&](const TechniqueInfo&, const params::ParamList& list) {
        std::size_t members = 0;
        int rank = 0;
        std::set<std::string> names;
        for (const params::ParamGroup& group : params::grouped(list)) {
            ++groups;
            members += group.params.size();
            EXPECT_TRUE(names.insert(group.name).second) << group.name << " twice";
            const int its = group.name.empty()                        ? 0
                            : group.name == params::kTeachingSwitches ? 2
                            : group.name == params::kExpert           ? 3
                                                                      : 1;
            EXPECT_GE(its, rank) << group.name;
            rank = its;
        }
        EXPECT_EQ(members, list.size());
    });
    EXPECT_GE(parameters, kLeastParameters);
    EXPECT_GE(groups, 30u);
}

} // namespace
} // namespace shadowlab
