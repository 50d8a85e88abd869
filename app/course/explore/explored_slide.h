// An explorable slide, computed: every picture, number and answer that its lab in the page shows.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/course/deck.h"
#include "app/course/explore/explore.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::course {

/// A technique of the slide with its settings, and which of its stages can be looked at.
struct ExploredPane {
    lab::PaneState state; ///< without a stage
    std::vector<picture::StageRef> stages;
};

/// The techniques of the slide's first scene, one or two; drawings of a pixel count for the technique that they are of. Throws Error
/// (badInput) for a slide without any, and for stages or settings that none of them has.
std::vector<ExploredPane> panesOf(const Slide& slide, const Explore& explore);

/// How much of what a slide asks for is computed.
struct ExploreSize {
    ivec2 picture{768, 432};
    int lampPositions = 24;
    int positionsWithSteps = 4; ///< at how many of them stages and steps can be looked at
    int askPoints = 24;
    int askPositions = 3; ///< at how many of them pixels can be asked
};

/// Frame times that were measured, by what they are of: a page that is made again shows the same.
using FrameTimes = std::map<std::string, double>;

struct ExploredSlide {
    std::string json;                ///< what the page's script reads (docs/explore.md)
    std::vector<std::uint8_t> bytes; ///< that `json` refers to: sheets of tiles, answers
    std::size_t stateBytes = 0;      ///< of `bytes`: pictures, verdicts and truths; the rest is stages, steps and answers
    int solvedStates = 0;            ///< in how many of them the task is solved
};

struct ExploreRequest {
    ExploreSize size;
    int supersample = 1;             ///< N x N samples for a pixel of a picture; verdicts are those of pixel centres
    int lampPositionsToDraw = 0;     ///< a trial draws a few of them alone, stages and steps at one, and asks no pixel; 0: all
    std::string machine{};           ///< what the times of frames were measured on
    std::function<void()> onState{}; ///< after every state that was drawn; may throw
};

/// `times` is asked first, and takes what was measured. Needs a current GL context. Throws Error (badInput, usage).
ExploredSlide exploredSlide(const Slide& slide, const Explore& explore, const ExploreRequest& request, const image::Font& font,
                            const image::Font& bold, FrameTimes& times);

/// How many states a slide has: what onState is called for.
int exploredStates(const Slide& slide, const Explore& explore, const ExploreSize& size);

} // namespace shadowlab::course
