// SPDX-License-Identifier: MIT
#include "app/cli/explored_deck.h"

#include <algorithm>

#include "app/cli/json/json_values.h"
#include "app/cli/messages.h"
#include "app/context/assets.h"
#include "app/context/context.h"
#include "app/course/explore/explore_budget.h"
#include "app/course/explore/explore_page.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::cli {

namespace {

constexpr const char* kTimesMark = "how long frames of explorable slides took, in ms; delete this file to measure them anew";
constexpr std::uint64_t kLargestTimes = 1 << 22; ///< bytes: 300 slides of 30 settings

} // namespace

ExploredDeck::ExploredDeck(const std::filesystem::path& folder, const std::string& deck, std::size_t budgetBytes, int slides,
                           int supersample)
    : timesFile_(folder / (deck + ".times.json")), equalBytes_(budgetBytes / static_cast<std::size_t>(std::max(1, slides))), bytesLeft_(budgetBytes),
      slidesLeft_(slides), supersample_(supersample),
      font_(context::assetsRoot() / "fonts" / "DejaVuSans.ttf"), bold_(context::assetsRoot() / "fonts" / "DejaVuSans-Bold.ttf") {
    readTimes();
}

std::string ExploredDeck::elementsOf(const course::Slide& slide, const std::function<void()>& onState) {
    // Up to twice an equal share, because most slides need less; but half of one is left for each of those that follow.
    const std::size_t kept = static_cast<std::size_t>(std::max(0, slidesLeft_ - 1)) * (equalBytes_ / 2);
    const std::size_t share = std::min(2 * equalBytes_, bytesLeft_ - std::min(bytesLeft_, kept));
    course::ExploreRequest request;
    request.supersample = slide.supersample.value_or(supersample_);
    request.machine = context::glRenderer();
    request.onState = onState;
    const course::FittedSlide fitted = course::fittedSlide(slide, *slide.explore, request, share, font_, bold_, times_);
    if (!fitted.lessThanAsked.empty())
        note("slide '" + slide.name + "': " + fitted.lessThanAsked + ", to stay within its share of --explore-budget");
    if (slide.explore->task && fitted.explored.solvedStates == 0)
        note("slide '" + slide.name + "': nowhere on the lamp's track, and with none of the settings, its task is solved: " +
             slide.explore->task->number + " is never " + slide.explore->task->bound.text());
    countStanding(course::pageBytes(fitted.explored));
    writeTimes();
    return course::exploreElements(slide.name, fitted.explored);
}

void ExploredDeck::countStanding(std::size_t bytes) {
    bytesLeft_ -= std::min(bytesLeft_, bytes);
    --slidesLeft_;
}

void ExploredDeck::readTimes() {
    std::error_code ignored;
    if (!std::filesystem::exists(std::filesystem::symlink_status(timesFile_, ignored))) return;
    isForeign_ = true;
    try {
        const Json all = Json::parse(scene::readFile(timesFile_, kLargestTimes));
        if (all.at("shadowlab") != kTimesMark) throw Error(ExitStatus::badInput, "another mark");
        times_ = all.at("times").get<course::FrameTimes>();
        isForeign_ = false;
    } catch (const Error&) {
    } catch (const Json::exception&) {
    }
    if (isForeign_)
        note(scene::shownPath(timesFile_) + ": is none of ours, so times of frames are measured, and not kept; move it away");
}

void ExploredDeck::writeTimes() const {
    if (!isForeign_) image::writeWhole(timesFile_, Json{{"shadowlab", kTimesMark}, {"times", times_}}.dump(1) + "\n");
}

} // namespace shadowlab::cli
