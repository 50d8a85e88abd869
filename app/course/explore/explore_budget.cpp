// SPDX-License-Identifier: MIT
#include "app/course/explore/explore_budget.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::course {

namespace {

struct Share {
    double lamp; ///< of the positions that are asked for
    int width;   ///< of a picture, 16 : 9
    double asked; ///< of the pixels
};
// A smaller picture is worse to look at than a lamp that moves in larger steps, until its steps are 15 degrees and more.
constexpr std::array kShares{Share{1, 768, 1},       Share{1, 640, 1},         Share{1, 512, 1},       Share{2.0 / 3, 512, 1}, Share{1.0 / 2, 512, 1},
                             Share{1.0 / 2, 384, 0.5}, Share{1.0 / 3, 384, 0.5}, Share{1.0 / 4, 320, 0.25}, Share{1.0 / 8, 320, 0.25}};
constexpr int kLeastPositions = 4, kPositionsWithSteps = 6, kAskPositions = 3, kTrialPositions = 3;

ExploreSize sizeOf(const Explore& explore, const Share& share) {
    ExploreSize size;
    size.picture = {share.width, share.width * 9 / 16};
    const int least = std::min(kLeastPositions, explore.lampPositions);
    size.lampPositions = std::max(least, static_cast<int>(std::lround(explore.lampPositions * share.lamp)));
    size.positionsWithSteps = kPositionsWithSteps;
    size.askPositions = share.asked < 1 ? 1 : kAskPositions;
    size.askPoints = static_cast<int>(std::lround(explore.askPoints * share.asked));
    return size;
}

std::string differenceText(const ExploreSize& asked, const ExploreSize& chosen) {
    std::string text;
    if (chosen.lampPositions != asked.lampPositions)
        text = std::to_string(chosen.lampPositions) + " of " + std::to_string(asked.lampPositions) + " positions of the lamp";
    if (chosen.picture != asked.picture)
        text += (text.empty() ? "" : ", ") + ("pictures of " + std::to_string(chosen.picture.x)) + " x " + std::to_string(chosen.picture.y);
    if (chosen.askPoints != asked.askPoints)
        text += (text.empty() ? "" : ", ") + std::to_string(chosen.askPoints) + " of " + std::to_string(asked.askPoints) + " pixels to ask";
    return text;
}

/// What is known of the slide's bytes from a try: those that grow with the positions of the lamp, and the rest.
struct Known {
    double stateBytes = 0, otherBytes = 0; ///< in the page
    ivec2 picture{1};
    int positions = 1;
};
Known knownFrom(const ExploredSlide& tried, ivec2 picture, int positions) {
    const auto all = static_cast<double>(pageBytes(tried));
    const double share = tried.bytes.empty() ? 0 : static_cast<double>(tried.stateBytes) / static_cast<double>(tried.bytes.size());
    return {all * share, all * (1 - share), picture, positions};
}

/// What they become in another size. Bytes grow a little slower than pixels.
double estimatedBytes(const Known& known, const ExploreSize& size) {
    constexpr double kGrowth = 0.85;
    const double side = static_cast<double>(size.picture.x) / known.picture.x;
    return (known.stateBytes * size.lampPositions / known.positions + known.otherBytes) * std::pow(side * side, kGrowth);
}

} // namespace

ExploreSize askedSize(const Explore& explore) { return sizeOf(explore, kShares.front()); }

std::size_t pageBytes(const ExploredSlide& explored) { return (explored.bytes.size() + 2) / 3 * 4 + explored.json.size(); }

FittedSlide fittedSlide(const Slide& slide, const Explore& explore, ExploreRequest request, std::size_t mostBytes, const image::Font& font,
                        const image::Font& bold, FrameTimes& times) {
    const ExploreSize asked = askedSize(explore);
    request.size = asked;
    Known known;
    std::size_t bytes = 0;
    if (asked.lampPositions > 2 * kTrialPositions) { // where a trial would be most of the work, the first try is one
        ExploreRequest trial = request;
        trial.lampPositionsToDraw = kTrialPositions;
        trial.onState = {};
        known = knownFrom(exploredSlide(slide, explore, trial, font, bold, times), asked.picture, kTrialPositions);
        known.otherBytes *= kPositionsWithSteps; // of which a trial has one; answers come beside, mostly as much as one more
    }
    for (const Share& share : kShares) {
        request.size = sizeOf(explore, share);
        const bool isLast = &share == &kShares.back();
        if (!isLast && estimatedBytes(known, request.size) > static_cast<double>(mostBytes)) continue;
        ExploredSlide explored = exploredSlide(slide, explore, request, font, bold, times);
        bytes = pageBytes(explored);
        if (bytes <= mostBytes) return {std::move(explored), request.size, differenceText(asked, request.size)};
        known = knownFrom(explored, request.size.picture, request.size.lampPositions);
    }
    constexpr std::size_t kMegabyte = 1000000;
    throw Error(ExitStatus::overLimit, "needs " + std::to_string(bytes / kMegabyte + 1) + " MB of the page even with " +
                                           std::to_string(request.size.lampPositions) +
                                           " positions of the lamp; give a larger --explore-budget, or explore fewer slides");
}

} // namespace shadowlab::course
