// SPDX-License-Identifier: MIT
#include "app/course/explore/explored_variants.h"

#include <algorithm>

#include "techniques/foundation/params/in_words.h"

namespace shadowlab::course {

namespace {

Knob knobOf(const ExploredSetting& setting, const std::vector<ExploredPane>& panes) {
    Knob knob{setting.technique + "." + setting.param, "", setting.values, {}, 0};
    const auto pane = std::ranges::find(panes, setting.technique, [](const ExploredPane& one) { return one.state.technique; });
    picture::Slot slot = std::move(slotsOf({pane->state}).front()); // panesOf() has made sure that one shows the technique
    const params::Param& param = params::find(slot.params, setting.param, setting.technique);
    knob.label = params::labelOf(param) + (param.unit.empty() ? "" : ", " + param.unit);
    const std::string own = params::valueText(param);
    const auto found = std::ranges::find(knob.values, own);
    knob.start = static_cast<int>(found - knob.values.begin());
    if (found == knob.values.end()) knob.values.push_back(own);
    for (const std::string& value : knob.values)
        knob.labels.push_back(valueWords(value, param));
    return knob;
}

} // namespace

std::string valueWords(const std::string& value, const params::Param& param) {
    const bool isNumber = param.kind == params::Kind::integer || param.kind == params::Kind::real;
    return isNumber ? value : params::inWords(value, param);
}

ExploredVariants variantsOf(const std::vector<ExploredPane>& panes, const Explore& explore) {
    ExploredVariants all;
    std::vector<int> start;
    for (const ExploredSetting& setting : explore.settings) {
        all.knobs.push_back(knobOf(setting, panes));
        start.push_back(all.knobs.back().start);
    }
    all.combinations.push_back(start);
    for (const ExploredPane& pane : panes) {
        all.drawn.push_back({pane.state});
        all.places.push_back({0});
    }
    for (std::size_t k = 0; k < all.knobs.size(); ++k)
        for (int value = 0; value < static_cast<int>(all.knobs[k].values.size()); ++value) {
            if (value == start[k]) continue;
            all.combinations.push_back(start);
            all.combinations.back()[k] = value;
            const ExploredSetting& setting = explore.settings[k];
            for (std::size_t pane = 0; pane < panes.size(); ++pane) {
                const bool concerns = panes[pane].state.technique == setting.technique;
                all.places[pane].push_back(concerns ? static_cast<int>(all.drawn[pane].size()) : 0);
                if (!concerns) continue;
                lab::PaneState state = panes[pane].state;
                state.settings[setting.technique][setting.param] = all.knobs[k].values[static_cast<std::size_t>(value)];
                all.drawn[pane].push_back(std::move(state));
            }
        }
    return all;
}

} // namespace shadowlab::course
