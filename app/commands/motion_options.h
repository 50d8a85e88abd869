// The options of a sequence of frames, the same for every command that draws one.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "app/commands/option_values.h"
#include "app/session/motion.h"

namespace shadowlab::commands {

constexpr int kMostFrames = 100000;

struct MotionOptions {
    std::optional<int> frames; ///< nothing: one
    std::optional<double> orbitLightDegrees, orbitCameraDegrees;
};

void describeMotion(CLI::App& command);

/// Throws Error (usage) for what is wrong in itself, or contradicts itself.
MotionOptions motionOptions(const GivenOptions& given);

/// The motion that is meant for this scene.
session::Motion motionOf(const MotionOptions& options, const scene::Scene& scene);

} // namespace shadowlab::commands
