// The numbers beside a state of an explorable slide: those of `measure`, by the same names.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>
#include <string_view>

namespace shadowlab::course {

/// None where a technique publishes no visibility, or the scene has no light.
struct ExploredNumbers {
    std::optional<double> coreErrors;                        ///< pixels that are wrong far from any true edge: not by aliasing
    std::optional<double> falseLit, falseShadow;             ///< pixels that are in truth in shadow, and in truth lit
    std::optional<double> compared;                          ///< pixels with a surface, ties left out
    std::optional<double> edgeErrorPx;                       ///< wrong pixels for each pixel of the true boundary
    std::optional<double> frameMs;                           ///< median over the lamp's positions: a frame after the lamp has moved
};

struct ExploredNumber {
    std::string_view key;
    std::optional<double> ExploredNumbers::*value;
};
inline constexpr std::array kExploredNumbers{
    ExploredNumber{"coreErrors", &ExploredNumbers::coreErrors},
    ExploredNumber{"falseLit", &ExploredNumbers::falseLit},
    ExploredNumber{"falseShadow", &ExploredNumbers::falseShadow},
    ExploredNumber{"compared", &ExploredNumbers::compared},
    ExploredNumber{"edgeErrorPx", &ExploredNumbers::edgeErrorPx},
    ExploredNumber{"frameMs", &ExploredNumbers::frameMs}};

} // namespace shadowlab::course
