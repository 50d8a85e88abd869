// SPDX-License-Identifier: MIT
#include "app/figures/rays/tree_layout.h"

#include <algorithm>

#include "app/drawing/labels.h"

namespace shadowlab::figures {

TreeLayout::TreeLayout(const Probe& probe, const ShownTree& shown)
    : probe_(probe), shown_(shown), places_(probe.tree.size()) {
    if (!shown.rays.empty()) place(shown.rays.front(), 0);
}

void TreeLayout::place(int ray, int level) {
    levels_ = std::max(levels_, level + 1);
    double first = -1, last = -1;
    for (const int child : shown_.rays) {
        if (probe_.tree[static_cast<std::size_t>(child)].parent != ray) continue;
        place(child, level + 1);
        last = place(child).x;
        if (first < 0) first = last;
    }
    const double x = first < 0 ? ends_++ : 0.5 * (first + last);
    places_[static_cast<std::size_t>(ray)] = {x, level};
}

std::string shortened(const image::Font& font, std::string text, double em, double width) {
    if (drawing::textSize(font, text, em).x <= width) return text;
    while (!text.empty() && drawing::textSize(font, text + "...", em).x > width) {
        do
            text.pop_back();
        while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80); // the middle of a character
    }
    return text + "...";
}

std::string endName(const Probe::Node& node) {
    if (node.end.starts_with("not followed")) return "not followed";
    if (node.end.starts_with("none")) return "total reflection";
    return "background";
}

} // namespace shadowlab::figures
