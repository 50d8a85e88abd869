// SPDX-License-Identifier: MIT
#include "app/hard/columns.h"

#include "techniques/registry.h"

namespace shadowlab::hard {

namespace {

/// Settings that make a technique exact; none: it is by default.
struct ExactWay {
    std::string_view technique;
    lab::Values values;
};

const std::vector<ExactWay>& exactWays() {
    static const std::vector<ExactWay> ways{
        {"shadow-map-exact", {}},
        {"shadow-map-alias-free", {}},
        {"shadow-volume-zpass", {{"eye-correction", "true"}, {"repair", "true"}}},
        {"shadow-volume-zfail", {{"repair", "true"}}},
        {"shadow-volume", {}},
        {"ray-traced", {}},
    };
    return ways;
}

} // namespace

std::string Column::title() const {
    std::string title = technique;
    for (const auto& [id, value] : values)
        title += " " + id + "=" + value;
    return title;
}

std::vector<Column> columns() {
    std::vector<Column> columns;
    for (const RegisteredTechnique& registered : techniquesOf(TechniqueGroup::production)) {
        const TechniqueInfo& info = *registered.info;
        if (!publishes(info, kVisibilityStage)) continue;
        columns.push_back({std::string(info.id), {}, false});
        for (const ExactWay& way : exactWays()) {
            if (way.technique != info.id) continue;
            if (way.values.empty())
                columns.back().isExact = true;
            else
                columns.push_back({std::string(info.id), way.values, true});
        }
    }
    return columns;
}

} // namespace shadowlab::hard
