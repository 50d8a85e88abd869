// SPDX-License-Identifier: MIT
#include "techniques/foundation/base/nearest_names.h"

#include <algorithm>
#include <numeric>

namespace shadowlab {

namespace {

std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({substituted, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

} // namespace

std::vector<std::string> nearestNames(std::string_view typed, std::span<const std::string> known) {
    const std::size_t reach = std::max<std::size_t>(2, typed.size() / 3);
    std::vector<std::pair<std::size_t, std::string>> near;
    for (const std::string& name : known)
        if (const std::size_t distance = editDistance(typed, name); distance <= reach)
            near.emplace_back(distance, name);
    std::ranges::sort(near);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < near.size() && i < 3; ++i)
        names.push_back(near[i].second);
    return names;
}

std::string suggestion(std::string_view typed, std::span<const std::string> known) {
    const std::vector<std::string> near = nearestNames(typed, known);
    std::string text;
    if (near.empty()) {
        for (const std::string& name : known)
            text += (text.empty() ? "known: " : ", ") + name;
        return text;
    }
    for (const std::string& name : near)
        text += (text.empty() ? "did you mean \"" : " or \"") + name + "\"";
    return text + "?";
}

} // namespace shadowlab
