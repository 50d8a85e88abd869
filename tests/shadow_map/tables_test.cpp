// The tables of filters and biases: each entry has its shader, is a choice of its parameter, and names parameters that exist.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "techniques/foundation/gl/shader_source.h"
#include "techniques/shadow_map/bias/biases.h"
#include "techniques/shadow_map/filters/filters.h"
#include "techniques/shadow_map/filters/moment_filters.h"
#include "techniques/source_text.h"

namespace shadowlab::shadow_map {
namespace {

// All that the program had when the tables were made: fewer would be a loss.
constexpr std::size_t kLeastFilters = 9, kLeastBiases = 7;

/// Text of an embedded shader; empty: there is none of that name.
std::string_view shaderText(std::string_view name) {
    for (const gl::EmbeddedShader& shader : gl::embeddedShaders())
        if (shader.name == name) return shader.text;
    return {};
}

/// `table`: entries with a name and a shader; `choice`: the parameter that chooses among them; `list`: it, and all that they may read.
template <typename Table>
void expectWhole(const Table& table, std::string_view choice, params::ParamList list, std::string_view function) {
    const std::vector<std::string> choices = params::find(list, choice, "shadow-map").choices;
    ASSERT_EQ(choices.size(), table.size());
    std::set<std::string_view> read, names;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const auto& entry = table[i];
        SCOPED_TRACE(entry.name);
        EXPECT_EQ(choices[i], entry.name) << "an entry's place in the table is its number";
        EXPECT_TRUE(names.insert(entry.name).second) << "two entries of one name";
        EXPECT_NE(shaderText(entry.shader).find(function), std::string_view::npos)
            << "there is no shader " << entry.shader << " that defines " << function;
        for (const std::string_view param : entry.params)
            if (!param.empty()) read.insert(param);
    }
    for (const std::string_view param : read)
        EXPECT_TRUE(std::ranges::any_of(list, [&](const params::Param& known) { return known.id == param; }))
            << "no parameter " << param;
    for (const params::Param& known : list)
        EXPECT_TRUE(known.id == choice || read.contains(known.id)) << "nothing reads " << known.id;
}

TEST(ShadowMapTables, EveryFilterIsWhole) {
    ASSERT_GE(filters().size(), kLeastFilters);
    FilterParams params;
    expectWhole(filters(), "filter", describe(params), "float filteredVisibility(MapPlace place)");
    const SourceText source = SourceText::read();
    std::size_t anchors = 0;
    for (const FilterInfo& filter : filters()) {
        params.kind = filterNamed(filter.name);
        EXPECT_EQ(&filterInfo(params.kind), &filter);
        EXPECT_GE(filter.radiusTexels(params), 0) << filter.name;
        if (filter.moments) {
            EXPECT_NE(shaderText(filter.moments->shader).find("vec4 momentsOf(float z)"), std::string_view::npos)
                << filter.name;
        }
        for (const std::string_view anchor : filter.anchors) {
            if (anchor.empty()) continue;
            EXPECT_EQ(source.at(anchor).file, "shaders/" + std::string(filter.shader));
            ++anchors;
        }
    }
    EXPECT_GE(anchors, kLeastFilters);
    EXPECT_ANY_THROW(filterNamed("no such filter"));
}

TEST(ShadowMapTables, EveryBiasIsWhole) {
    ASSERT_GE(biases().size(), kLeastBiases);
    BiasParams params;
    expectWhole(biases(), "bias-mode", describe(params), "float depthToCompare(MapPlace place, vec2 offsetUv)");
    for (const BiasInfo& bias : biases()) {
        EXPECT_EQ(&biasInfo(biasNamed(bias.name)), &bias);
        EXPECT_NE(shaderText(bias.shader).find("vec4 biasedClip(vec4 lightClip, int layer)"), std::string_view::npos)
            << bias.name;
    }
    EXPECT_ANY_THROW(biasNamed("no such bias"));
}

// A parameter has an effect exactly while the chosen filter reads it.
TEST(ShadowMapTables, ParametersAreThoseOfTheChosenFilter) {
    FilterParams params;
    params::ParamList list = describe(params);
    int asked = 0;
    for (const FilterInfo& filter : filters()) {
        params.kind = filterNamed(filter.name);
        for (const params::Param& param : list)
            if (param.id != "filter") {
                EXPECT_EQ(params::hasEffect(param), filter.reads(param.id)) << filter.name << " and " << param.id;
                ++asked;
            }
    }
    EXPECT_GE(asked, 150); // nine filters, and some twenty parameters
}

} // namespace
} // namespace shadowlab::shadow_map
