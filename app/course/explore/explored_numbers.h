// The numbers beside a state of an explorable slide: those of `measure`, by the same names.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>
#include <string_view>

namespace shadowlab::course {

/// None where a technique publishes no visibility, or the scene has no light.
struct ExploredNumbers {
    std::optional<double> coreErrors, falseLit, falseShadow; ///< pixels
    std::optional<double> compared;                          ///< pixels with a surface, ties left out
    std::optional<double> edgeErrorPx;                       ///< wrong pixels for each pixel of the true boundary
    std::optional<double> frameMs;                           ///< median over the lamp's positions: a frame after the lamp has moved
};

struct ExploredNumber {
    std::string_view key, title;
    std::optional<double> ExploredNumbers::*value;
};
inline constexpr std::array kExploredNumbers{
    ExploredNumber{"coreErrors", "wrong, not by aliasing", &ExploredNumbers::coreErrors},
    ExploredNumber{"falseLit", "lit, in truth in shadow", &ExploredNumbers::falseLit},
    ExploredNumber{"falseShadow", "in shadow, in truth lit", &ExploredNumbers::falseShadow},
    ExploredNumber{"compared", "compared", &ExploredNumbers::compared},
    ExploredNumber{"edgeErrorPx", "edge error, px", &ExploredNumbers::edgeErrorPx},
    ExploredNumber{"frameMs", "ms", &ExploredNumbers::frameMs}};

} // namespace shadowlab::course
