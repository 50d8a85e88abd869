// SPDX-License-Identifier: MIT
#include "app/student/search/search.h"

#include <algorithm>
#include <utility>

#include "app/picture/stage_ref.h"
#include "app/student/grading/left_files.h"
#include "app/student/grading/picture_difference.h"
#include "app/student/search/shrink.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::student {

namespace {

using Clock = std::chrono::steady_clock;

// Of the time; the rest is for making a scene smaller.
constexpr double kForTrying = 0.75;
// A scene that a student takes in at once: a box, or three pyramids. Where the first that fails cannot be made so small, others are tried.
constexpr int kSmall = 12;

bool hasOneColour(const image::Image& picture) {
    for (std::size_t i = image::kChannels; i < picture.rgba.size(); ++i)
        if (picture.rgba[i] != picture.rgba[i - image::kChannels]) return false;
    return true;
}

bool isOfSize(const image::Image& picture, const image::Image& other) {
    return picture.width == other.width && picture.height == other.height;
}

// Of 255 levels: rounding.
constexpr int kLevels = 4;

/// Pixels in which a stage differs from the right one. Some are drawn over the finished picture: where that differs, it says nothing.
int differing(const image::Image& stage, const image::Image& right, const image::Image& picture, const image::Image& rightPicture) {
    const PictureDifference found = difference(stage, right, kLevels);
    if (!isOfSize(stage, picture)) return found.count;
    const PictureDifference below = difference(picture, rightPicture, kLevels);
    int count = 0;
    for (std::size_t i = 0; i < found.wrong.size(); ++i)
        count += found.wrong[i] && !below.wrong[i];
    return count;
}

/// Shows the stage nothing: one colour, or the finished picture alone?
bool isBlank(const image::Image& stage, const image::Image& picture) {
    return hasOneColour(stage) || (isOfSize(stage, picture) && difference(stage, picture, kLevels).count == 0);
}

/// Nothing where the scene has nothing to show in it.
std::optional<image::Image> stageOf(SceneDrawer& right, const View& view, const StageKey& key) {
    try {
        return right.picture(view, key);
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// The first stage of the lecture's algorithm that the plug-in has as well, and shows otherwise.
std::optional<StageEvidence> evidence(SceneTrials& trials, int light) {
    SceneDrawer& right = trials.drawerOf(rightTechnique(trials.family()));
    const View view = foundView(*right.session().snapshot());
    const std::vector<std::string>& its = trials.painter().stages();
    const image::Image rightPicture = right.picture(view, {});
    // A share of the pixels: rounding changes a few, and lines of an outline.
    constexpr int kShare = 100;
    for (const StageInfo& stage : right.info().stages) {
        if (stage.id == kVisibilityStage || std::ranges::find(its, stage.id) == its.end()) continue;
        const StageKey key{std::string(stage.id), stage.perLight ? std::max(light, 0) : kNoLight};
        if (stage.perLight && right.session().snapshot()->lights.empty()) continue;
        const std::optional<image::Image> rightly = stageOf(right, view, key);
        if (!rightly || isBlank(*rightly, rightPicture)) continue;
        const Painted painted = trials.painter().paint(trials.lastScene(), {key, StageKey{}});
        if (!painted.failure.empty()) continue;
        // Of a stage its own size is the plug-in's choice, as that of a map.
        const std::optional<image::Image> shown = pictureIn(painted.files[0]), picture = pictureIn(painted.files[1], view.size);
        if (!shown || !picture) continue;
        if (isBlank(*shown, *picture)) return StageEvidence{key.id, true};
        if (!isOfSize(*shown, *rightly) || differing(*shown, *rightly, *picture, rightPicture) > rightly->width * rightly->height / kShare)
            return StageEvidence{key.id, false};
    }
    return std::nullopt;
}

/// What a lesson can say of it: wrong pixels at twice the size on a side.
void measureForLesson(SceneTrials& trials, Finding& finding) {
    constexpr int kDouble = 2;
    SceneDrawer& right = trials.drawerOf(rightTechnique(trials.family()));
    const View view = foundView(*right.session().snapshot(), kDouble);
    const bool isPicture = finding.trial.light < 0;
    const StageKey key = isPicture ? StageKey{} : picture::visibilityOf(finding.trial.light);
    const Painted painted = trials.painter().paint(trials.lastScene(), {key}, kDouble);
    if (!painted.failure.empty()) return;
    if (isPicture) {
        if (const std::optional<image::Image> picture = pictureIn(painted.files.front(), view.size))
            finding.wrongAtDouble = difference(*picture, right.picture(view, key), 0).count;
        return;
    }
    if (painted.files.front().size() != 2 * static_cast<std::size_t>(view.size.x) * static_cast<std::size_t>(view.size.y)) return;
    const judge::Truth& truth = right.session().truth(view, picture::LightTruth(finding.trial.light));
    finding.rightAtDouble = judge::judge(truth, right.visibility(view, finding.trial.light)).counts.wrong();
    finding.wrongAtDouble = judge::judge(truth, painted.files.front()).counts.wrong();
}

/// `hadPicture`: the scene fails by what it shows, not by showing nothing.
Finding madeSmall(SceneTrials& trials, const SearchScene& scene, int number, bool hadPicture, const std::function<bool()>& mayGoOn) {
    Finding finding{number, &kindOf(trials.family(), number), {}, {}, 0, triangleCount(scene), true, {}, 0, 0};
    const Judged judged = finding.kind->judged;
    const int least = leastWrong(trials.family(), judged);
    // What fails in the one way is not exchanged for what fails in the other.
    const auto stillFails = [&](const SearchScene& smaller) {
        const Trial trial = trials.tryScene(smaller, judged);
        return trial.fails(least) && trial.failure.empty() == hadPicture;
    };
    Shrunk shrunk = shrink(scene, stillFails, mayGoOn);
    finding.scene = std::move(shrunk.scene);
    finding.attempts = shrunk.attempts;
    finding.trial = trials.tryAnew(finding.scene, judged);
    finding.isFresh = finding.trial.fails(least);
    if (finding.isFresh && hadPicture) {
        finding.stage = evidence(trials, finding.trial.light);
        measureForLesson(trials, finding);
    }
    return finding;
}

} // namespace

SearchResult search(SceneTrials& trials, const SearchPlan& plan, const std::function<void(int)>& done) {
    const Clock::time_point begin = Clock::now();
    SearchResult result;
    const auto isSmall = [&] { return result.finding && triangleCount(result.finding->scene) <= kSmall; };
    for (int number = 0; number < plan.scenes && !isSmall(); ++number) {
        if (Clock::now() - begin > kForTrying * plan.time) {
            result.isOutOfTime = !result.finding;
            break;
        }
        const SearchScene scene = randomScene(trials.family(), plan.seed, number);
        const Judged judged = kindOf(trials.family(), number).judged;
        const Trial trial = trials.tryScene(scene, judged);
        ++result.tried;
        result.unfair += !trial.isFair;
        done(result.tried);
        if (!trial.fails(leastWrong(trials.family(), judged))) continue;
        Finding finding = madeSmall(trials, scene, number, trial.failure.empty(), [&] { return Clock::now() - begin < plan.time; });
        if (!result.finding || triangleCount(finding.scene) < triangleCount(result.finding->scene)) result.finding = std::move(finding);
    }
    if (result.finding) trials.tryScene(result.finding->scene, result.finding->kind->judged); // again the last one
    return result;
}

} // namespace shadowlab::student
