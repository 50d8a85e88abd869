// SPDX-License-Identifier: MIT
#include "app/window/name_plates.h"

#include <algorithm>

namespace shadowlab::window {

namespace {

constexpr float kLeaderEm = 0.8f; ///< a name farther than that from its icon has a line to it

} // namespace

void NamePlates::add(ImVec2 icon, float radius, const std::string& name, ImU32 color, bool outlined) {
    names_.push_back({icon, radius, name, color, outlined});
    places_.take(PlaceBox::around(icon, radius), FreePlaces::kSign);
}

std::vector<PlaceBox> NamePlates::draw() {
    std::vector<PlaceBox> drawn;
    for (const Name& name : names_) {
        const float pad = theme_.em * 0.3f;
        const ImVec2 text = theme_.text->CalcTextSizeA(theme_.em, FLT_MAX, 0, name.text.c_str());
        const PlaceBox plate = bestPlace(name, {text.x + 2 * pad, text.y + pad});
        places_.take(plate, FreePlaces::kSign);
        if (plate.distance(name.icon) > name.radius + kLeaderEm * theme_.em || isNearAnother(name, plate)) drawLeader(name, plate);
        list_.AddRectFilled(plate.low, plate.high, kPlateColor);
        if (name.outlined) list_.AddRect(plate.low, plate.high, kPlateText, 0, 0, kOutline);
        list_.AddText(theme_.text, theme_.em, {plate.low.x + pad, plate.low.y + pad / 2}, name.color, name.text.c_str());
        drawn.push_back(plate);
    }
    return drawn;
}

/// Would a name there be taken for another icon's?
bool NamePlates::isNearAnother(const Name& name, const PlaceBox& plate) const {
    const float own = plate.distance(name.icon);
    return std::ranges::any_of(names_, [&](const Name& other) {
        return (other.icon.x != name.icon.x || other.icon.y != name.icon.y) && plate.distance(other.icon) <= own;
    });
}

/// From a name that found no room beside its icon.
void NamePlates::drawLeader(const Name& name, const PlaceBox& plate) {
    const ImVec2 from = plate.nearest(name.icon);
    const float away = plate.distance(name.icon);
    if (away <= name.radius) return;
    const float share = name.radius / away;
    const ImVec2 to(name.icon.x + (from.x - name.icon.x) * share, name.icon.y + (from.y - name.icon.y) * share);
    list_.AddLine(from, to, kSignRim, theme_.em * 0.2f);
    list_.AddLine(from, to, name.color, theme_.em * 0.1f);
}

/// Right, left, below and above it, then at its corners, and then the same farther away. Of places that cost the same the first is
/// taken.
PlaceBox NamePlates::bestPlace(const Name& name, ImVec2 size) const {
    PlaceBox best;
    float least = FLT_MAX;
    for (const float gapEm : {0.15f, 1.0f, 2.0f, 3.0f, 4.5f, 6.0f}) {
        const float r = name.radius + gapEm * theme_.em;
        const float right = name.icon.x + r, left = name.icon.x - r - size.x, middle = name.icon.x - size.x / 2;
        const float below = name.icon.y + r, above = name.icon.y - r - size.y, beside = name.icon.y - size.y / 2;
        for (const ImVec2 corner : {ImVec2(right, beside), ImVec2(left, beside), ImVec2(middle, below), ImVec2(middle, above),
                                    ImVec2(right, below), ImVec2(left, below), ImVec2(right, above), ImVec2(left, above)}) {
            const PlaceBox box = places_.within(corner, size);
            const float mistaken = isNearAnother(name, box) ? FreePlaces::kObject * size.x * size.y : 0;
            if (const float cost = places_.cost(box) + mistaken; cost < least) {
                best = box;
                least = cost;
            }
        }
        // Rather over an object than far from its icon.
        if (places_.cost(best, FreePlaces::kSign) == 0) break;
    }
    return best;
}

} // namespace shadowlab::window
