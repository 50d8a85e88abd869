// The options of `capture` that depend on each other: read, and refused where they contradict. Each function throws Error (usage).
// SPDX-License-Identifier: MIT
#pragma once
#include "app/cli/capture/capture.h"
#include "app/cli/options.h"

namespace shadowlab::cli {

picture::Layout layoutFor(const GivenOptions& given, std::size_t slots);

/// --split: the share of the width that the left one of two bands has.
double splitFor(const GivenOptions& given, picture::Layout layout, std::size_t slots);

/// The stage of each technique: `STAGE` is that of all of them, `2:STAGE` that of the second.
std::vector<picture::StageRef> stagesFor(const GivenOptions& given, std::size_t slots);

/// "3,2,5,0,0,0": where the second camera stands, and where it looks.
std::array<double, 6> outsideFor(const GivenOptions& given, const std::vector<picture::StageRef>& stages);

/// --pixel or --partner: a pixel that the window has picked, or that a stage is about.
ivec2 pickedFor(const std::string& option, const GivenOptions& given, const CaptureOptions& options);

int rowFor(const GivenOptions& given, const std::vector<picture::StageRef>& stages, ivec2 size);

/// Refuses what cannot be in one file with other pictures.
void checkFilm(const CaptureOptions& options);

/// How long a step, or a frame, stays.
image::FrameTime timeFor(const GivenOptions& given, const CaptureOptions& options);

/// Samples of the largest panel on a side. Throws Error when the panels are too small to be drawn (usage) or all
/// together too large (overLimit).
int requireDrawable(const CaptureOptions& options);

} // namespace shadowlab::cli
