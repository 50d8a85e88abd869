// The names of what has an icon in one pane. They find their places when all icons are known: each beside its own, on the first side
// that is free of icons, of other names and of objects.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/window/free_places.h"

namespace shadowlab::window {

constexpr ImU32 kSignRim = IM_COL32(16, 16, 18, 255); ///< around icons and under lines
constexpr float kOutline = 3;                         ///< width of a selected thing's outline, pixels

class NamePlates {
public:
    NamePlates(ImDrawList& list, FreePlaces& places, const Theme& theme) : list_(list), places_(places), theme_(theme) {}

    /// The icon and its name. `radius`: of the icon with its rays.
    void add(ImVec2 icon, float radius, const std::string& name, ImU32 color, bool outlined);
    /// What belongs to an icon and must stay as free as it: the point of an edge mark.
    void keepFree(ImVec2 at, float radius) { places_.take(PlaceBox::around(at, radius), FreePlaces::kSign); }
    /// Draws the names, takes their places, and returns them.
    std::vector<PlaceBox> draw();

private:
    struct Name {
        ImVec2 icon;
        float radius;
        std::string text;
        ImU32 color;
        bool outlined;
    };
    [[nodiscard]] bool isNearAnother(const Name& name, const PlaceBox& plate) const;
    [[nodiscard]] PlaceBox bestPlace(const Name& name, ImVec2 size) const;
    void drawLeader(const Name& name, const PlaceBox& plate);

    ImDrawList& list_;
    FreePlaces& places_;
    const Theme& theme_;
    std::vector<Name> names_;
};

} // namespace shadowlab::window
