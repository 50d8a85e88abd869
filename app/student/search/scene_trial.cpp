// SPDX-License-Identifier: MIT
#include "app/student/search/scene_trial.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "app/judge/slot_errors.h"
#include "app/picture/stage_ref.h"
#include "app/student/grading/graded_scene.h"
#include "app/student/grading/left_files.h"
#include "app/student/grading/picture_difference.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/registry.h"

namespace shadowlab::student {

namespace {

// Of 14,400 pixels. With fewer of either, the picture asks little about shadows.
constexpr int kLeastOfEach = 100;
// A pixel here and there: cracks, and edges that rounding decides.
constexpr int kRightMayBeWrong = 6;
// A map of 1024 x 1024 texels is coarser than such a picture only where the light grazes: outlines may be off by two pixels.
constexpr float kMapReachPx = 2.5f;
// Two right ways to follow rays disagree at rims of curved glass; a scene where they do in more pixels (2 %) is not asked.
constexpr int kRaysMayDiffer = 288;

/// The wrong pixel that is nearest to the middle of all of them.
ivec2 amidst(const std::vector<bool>& isWrong) {
    dvec2 sum(0.0);
    int count = 0;
    const auto placeOf = [](std::size_t i) {
        return ivec2(static_cast<int>(i) % kSearchWidth, static_cast<int>(i) / kSearchWidth);
    };
    for (std::size_t i = 0; i < isWrong.size(); ++i)
        if (isWrong[i]) sum += dvec2(placeOf(i)), ++count;
    ivec2 best(-1);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < isWrong.size(); ++i)
        if (const double away = glm::distance(dvec2(placeOf(i)), sum / std::max(1.0, double(count))); isWrong[i] && away < least) {
            least = away;
            best = placeOf(i);
        }
    return best;
}

void addWrong(Trial& trial, std::vector<bool> isWrong) {
    trial.wrong = static_cast<int>(std::ranges::count(isWrong, true));
    trial.pixel = amidst(isWrong);
    trial.isWrong = std::move(isWrong);
}

} // namespace

int leastWrong(const Family& family, Judged judged) {
    if (family.id == "radiosity") return 720; // 5 %: patches that are divided otherwise differ along their borders
    if (family.id == "shadow-map") return 60; // beyond the reach of texels
    return judged == Judged::picture ? 60 : 40;
}

std::string countedText(const Family& family, Judged judged) {
    std::string text = "Counted in a picture of " + std::to_string(kSearchWidth) + " x " + std::to_string(kSearchHeight) + " pixels";
    const std::string right(rightTechnique(family));
    if (judged == Judged::picture)
        return text + ": those that are more than " + std::to_string(family.levels) + " of 255 levels off the picture of " + right + ".";
    text += ", without ties: those where " + right + " is right";
    if (family.id == "shadow-map") text += ", farther than " + scene::numberText(kMapReachPx) + " pixels from any true edge: the algorithm is wrong there, and not its texels alone";
    return text + ".";
}

std::string_view rightTechnique(const Family& family) {
    if (!family.reference.empty()) return family.reference;
    return family.id == "planar" ? "lecture-planar" : family.id == "shadow-map" ? "lecture-shadow-map" : "lecture-zfail";
}

std::string_view refinedTechnique(const Family& family) { return findTechnique(rightTechnique(family)).sister; }

SceneTrials::SceneTrials(const Candidate& candidate, const Family& family, const Conditions& conditions)
    : family_(family), painter_(candidate, conditions, folder_.path()) {}

SceneDrawer& SceneTrials::drawerOf(std::string_view technique) {
    auto found = drawers_.find(technique);
    if (found == drawers_.end()) {
        std::vector<std::string> settings = kSearchSettings;
        // As the lecture's tree of rays is by itself. Techniques of other families have no such parameters.
        if (technique == refinedTechnique(family_)) settings = {"depth=4", "fresnel=constant", "cutoff=0"};
        found = drawers_.emplace(technique, std::make_unique<SceneDrawer>(technique, snapshot_, settings)).first;
    }
    found->second->setScene(snapshot_);
    return *found->second;
}

Trial SceneTrials::tryScene(const SearchScene& scene, Judged judged) {
    const std::string stem = std::to_string(++written_);
    std::error_code ignored;
    if (!lastScene_.empty()) std::filesystem::remove_all(lastScene_.parent_path(), ignored);
    const std::filesystem::path folder = folder_.folder(stem);
    for (const auto& [name, text] : filesOf(scene, "scene", "A scene that is tried."))
        image::writeWhole(folder / name, text);
    lastScene_ = folder / "scene.json";
    try {
        snapshot_ = loadGradedScene(lastScene_);
    } catch (const Error&) {
        return {}; // smaller scenes may be none any more: an eye at its target, a mesh without area
    }
    return judged == Judged::visibility ? tryVisibility() : tryPicture();
}

Trial SceneTrials::tryAnew(const SearchScene& scene, Judged judged) {
    painter_.startAnew();
    return tryScene(scene, judged);
}

Trial SceneTrials::tryVisibility() {
    SceneDrawer& right = drawerOf(rightTechnique(family_));
    const View view = foundView(*snapshot_);
    std::vector<StageKey> stages;
    std::vector<std::vector<bool>> isAsked; // per light and pixel
    std::vector<Trial> trials;
    for (int light = 0; light < static_cast<int>(snapshot_->lights.size()); ++light) {
        const judge::Truth& truth = right.session().truth(view, picture::LightTruth(light));
        const judge::Judgement rightly = judge::judge(truth, right.visibility(view, light));
        std::vector<bool> asked(truth.visibility.size(), true);
        if (family_.id == "shadow-map") {
            const judge::Grid<float> away = judge::distanceToBoundary(judge::trueBoundary(truth), truth.size);
            for (std::size_t i = 0; i < asked.size(); ++i)
                asked[i] = away.values[i] > kMapReachPx;
        }
        int rightIsWrong = 0;
        for (std::size_t i = 0; i < asked.size(); ++i) {
            if (asked[i] && judge::isWrong(rightly.verdicts[i])) ++rightIsWrong;
            asked[i] = asked[i] && rightly.verdicts[i] == judge::Verdict::correct;
        }
        Trial trial;
        trial.light = light;
        trial.lit = rightly.counts.lit;
        trial.shadowed = rightly.counts.shadowed;
        trial.isFair = rightIsWrong <= kRightMayBeWrong && trial.lit >= kLeastOfEach && trial.shadowed >= kLeastOfEach;
        trials.push_back(std::move(trial));
        isAsked.push_back(std::move(asked));
        stages.push_back(picture::visibilityOf(light));
    }
    if (std::ranges::none_of(trials, &Trial::isFair)) return trials.empty() ? Trial() : trials.front();
    const Painted painted = painter_.paint(lastScene_, stages);
    const std::size_t bytes = 2 * static_cast<std::size_t>(kSearchWidth) * kSearchHeight;
    Trial worst;
    for (std::size_t light = 0; light < trials.size(); ++light) {
        Trial& trial = trials[light];
        if (!trial.isFair) continue;
        trial.failure = painted.failure;
        if (trial.failure.empty() && painted.files[light].size() != bytes) trial.failure = "it left no picture of the size that was asked for";
        if (!trial.failure.empty()) return trial;
        const judge::Truth& truth = right.session().truth(view, picture::LightTruth(static_cast<int>(light)));
        const judge::Judgement judged = judge::judge(truth, painted.files[light]);
        std::vector<bool> isWrong(judged.verdicts.size());
        for (std::size_t i = 0; i < isWrong.size(); ++i) {
            isWrong[i] = isAsked[light][i] && judge::isWrong(judged.verdicts[i]);
            if (!isWrong[i]) continue;
            trial.falseLit += judged.verdicts[i] == judge::Verdict::falseLit;
            trial.falseShadow += judged.verdicts[i] == judge::Verdict::falseShadow;
        }
        addWrong(trial, std::move(isWrong));
        if (trial.wrong > 0) {
            trial.atPixel = judged.verdicts[truth.index(trial.pixel.x, trial.pixel.y)];
            if (const std::uint32_t seen = truth.objects[truth.index(trial.pixel.x, trial.pixel.y)]; seen < snapshot_->objects.size())
                trial.object = snapshot_->objects[seen].name;
        }
        if (!worst.isFair || trial.wrong > worst.wrong) worst = std::move(trial);
    }
    return worst;
}

Trial SceneTrials::tryPicture() {
    const View view = foundView(*snapshot_);
    const image::Image right = drawerOf(rightTechnique(family_)).picture(view, {});
    std::vector<bool> asked(static_cast<std::size_t>(kSearchWidth) * kSearchHeight, true);
    Trial trial;
    trial.light = kNoLight;
    if (family_.id == "ray-tracing") {
        const PictureDifference other = difference(drawerOf(refinedTechnique(family_)).picture(view, {}), right, family_.levels);
        if (other.count > kRaysMayDiffer) return trial;
        for (std::size_t i = 0; i < asked.size(); ++i)
            asked[i] = !other.wrong[i];
    }
    // A picture that is dark nearly everywhere, as without any light, asks nothing.
    constexpr int kBright = 24;
    int bright = 0;
    for (std::size_t i = 0; i < right.rgba.size(); i += image::kChannels)
        bright += std::max({right.rgba[i], right.rgba[i + 1], right.rgba[i + 2]}) > kBright;
    trial.isFair = bright >= kLeastOfEach;
    if (!trial.isFair) return trial;
    const Painted painted = painter_.paint(lastScene_, {StageKey{}});
    trial.failure = painted.failure;
    if (!trial.failure.empty()) return trial;
    const std::optional<image::Image> picture = pictureIn(painted.files.front(), view.size);
    if (!picture) {
        trial.failure = "it left no picture of the size that was asked for";
        return trial;
    }
    std::vector<bool> isWrong = difference(*picture, right, family_.levels).wrong;
    for (std::size_t i = 0; i < isWrong.size(); ++i)
        isWrong[i] = isWrong[i] && asked[i];
    addWrong(trial, std::move(isWrong));
    return trial;
}

} // namespace shadowlab::student
