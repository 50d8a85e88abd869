// The options of a sequence of frames, the same for every command that draws one.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>

#include "app/cli/options.h"
#include "app/film/motion.h"

namespace shadowlab::cli {

struct MotionOptions {
    std::optional<int> frames; ///< nothing: to the last key of the path, else one
    std::optional<double> orbitLightDegrees, orbitCameraDegrees;
    std::filesystem::path path; ///< empty: none
};

void describeMotion(DescribedOptions& add);

/// Throws Error (usage) for what is wrong in itself, or contradicts itself.
MotionOptions motionOptions(const GivenOptions& given);

/// The motion of this scene. Reads the path. Throws Error (badInput, overLimit).
film::Motion motionOf(const MotionOptions& options, const scene::Scene& scene);

} // namespace shadowlab::cli
