// What of a hard case can be measured, described once: the reader of cases, the page about them and the measurement walk
// this list.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <span>
#include <string_view>

namespace shadowlab::hard {

struct Quantity {
    enum class Of {
        visibility, ///< one technique's answers, compared with the truth
        comparison, ///< two pictures, compared with each other
    };
    std::string_view id;
    Of of;
    std::string_view unit, help;
};

constexpr Quantity kQuantities[] = {
    {"wrong", Quantity::Of::visibility, "px",
     "lit but should be dark, dark but should be lit, or a surface where there is none"},
    {"falseLit", Quantity::Of::visibility, "px", "lit, but should be dark"},
    {"falseShadow", Quantity::Of::visibility, "px", "dark, but should be lit"},
    {"coreErrors", Quantity::Of::visibility, "px", "wrong pixels that are no aliasing"},
    {"differing", Quantity::Of::comparison, "px", "of the picture, that are not the same bytes as in that of `from`"},
    {"largestDifference", Quantity::Of::comparison, "of 255", "between the picture and that of `from`"},
    {"visibilityDiffers", Quantity::Of::comparison, "px", "whose visibility is not the same byte as with `from`"},
};

constexpr std::span<const Quantity> quantities() { return kQuantities; }

/// The one of that id; it must be one of the list.
inline const Quantity& quantity(std::string_view id) { return *std::ranges::find(kQuantities, id, &Quantity::id); }

} // namespace shadowlab::hard
