// What is exactly true of the point that one pixel shows, and who decides where the technique's own numbers do not tell.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "techniques/foundation/trace/judge/exact_visibility.h"

namespace shadowlab {

/// The point where the eye ray of the pixel ends, and the light that is asked about.
struct SeenPoint {
    std::string object; ///< empty: the background
    bool receivesShadow = true;
    int light = -1; ///< index; -1: the scene has none
    std::string lightName{};
    trace::Visibility truth = trace::Visibility::noSurface; ///< of the light's centre; noSurface: nothing is asked
    /// Of the light's area, or of the light as a patch sees it, 0..1; of a technique that knows it.
    std::optional<double> lightShare{};
};

/// Who decides whether light arrives, where it is not the count or the comparison that the probe shows.
struct Decider {
    std::string who; ///< "a ray: the map is not certain"
};

} // namespace shadowlab
