// Where the rays of a tree stand in a drawing of it, and what is said of each.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/figures/rays/shown_tree.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::figures {

/// Where the rays' ends stand: level by level, a parent over the middle of its children.
class TreeLayout {
public:
    TreeLayout(const Probe& probe, const ShownTree& shown);
    /// x in numbers of ends from the left, y in levels.
    [[nodiscard]] dvec2 place(int ray) const { return places_[static_cast<std::size_t>(ray)]; }
    [[nodiscard]] int ends() const { return ends_; }
    [[nodiscard]] int levels() const { return levels_; }

private:
    void place(int ray, int level);

    const Probe& probe_;
    const ShownTree& shown_;
    std::vector<dvec2> places_;
    int ends_ = 0, levels_ = 0;
};

/// As much of a text as is no wider than `width`.
std::string shortened(const image::Font& font, std::string text, double em, double width);

/// What a ray ends at, where that is no surface.
std::string endName(const Probe::Node& node);

} // namespace shadowlab::figures
