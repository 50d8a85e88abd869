// The result of a probe, as text for people and as JSON for programs.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "techniques/probe.h"

namespace shadowlab::cli {

/// A probed pixel, and how it was probed.
struct ProbedPixel {
    std::string scene, technique;
    std::string light; ///< empty: the scene has none
    ivec2 size{0}, pixel{0};
    std::optional<ivec2> partner{};
    Probe probe;
};

/// The verdict in one line and the sums that lead to it; then the details: facts a line each, and the tree, every ray indented below
/// the one it comes from.
std::string probeText(const ProbedPixel& probed);

/// One object, with all digits: {"verdict", "sums", "scene", "technique", "light", "size", "pixel", "partner", "facts", "vectors", "rays",
/// "tree", "exchange", "decision", "volume", "map", "plane"}.
std::string probeJson(const ProbedPixel& probed);

} // namespace shadowlab::cli
