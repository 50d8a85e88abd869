// SPDX-License-Identifier: MIT
#include "app/lab/errors/live_errors.h"

#include <algorithm>

#include "app/picture/difference_panel.h"
#include "app/picture/stages/scanline_plot.h"

namespace shadowlab::lab {

namespace {

constexpr double kBetweenTasks = 1.5; ///< seconds, while something moves: a judged frame costs more than others
constexpr double kRest = 0.2;         ///< seconds without motion, before the exact answer is worth its work

/// The visibility that a pane's technique can be judged by; a pass, or a scene without that light, has none.
bool canBeJudged(const PaneRequest& request) {
    if (request.state.stage.isPass || request.state.stage.isOutside()) return false;
    if (request.light < 0 || request.light >= static_cast<int>(request.snapshot->lights.size())) return false;
    return publishes(findTechnique(request.state.technique), kVisibilityStage);
}

/// Of a picture that is drawn coarser than the screen marks become wider on it.
int markWidthFor(ivec2 areaSize, int draft) {
    const int onScreen = picture::wideMark(areaSize.y), width = (onScreen + draft - 1) / draft;
    return width + (width % 2 == 0 ? 1 : 0);
}

} // namespace

LiveErrors::OnShow LiveErrors::onShow(const Workbench& bench, const std::vector<PlacedPane>& placed) {
    OnShow shown{bench.document().layout, {}};
    for (const PlacedPane& pane : placed)
        shown.requests.push_back(bench.requestFor(pane, bench.draft()));
    return shown;
}

bool LiveErrors::ask(Workbench& bench, ivec2 areaSize, double seconds) {
    wanted_.clear();
    const std::vector<PlacedPane> placed = bench.placed(areaSize);
    const OnShow shown = onShow(bench, placed);
    forgetOthers(bench, placed, shown);
    // What moves without a change of any picture, as the split line does, is no motion for the judge.
    if (!bench.isAtRest() && shown != exactFor_) restSince_ = seconds;
    isNew_ = bench.isAtRest() && shown != seen_;
    seen_ = shown;
    const bool rests = seconds - restSince_ >= kRest;
    if (shown != exactFor_) done_ = false;
    if (rests && shown != exactFor_ && !isNew_) {
        for (std::size_t i = 0; i < placed.size(); ++i)
            if (canBeJudged(shown.requests[i])) wanted_.push_back(placed[i].pane);
    } else if (!rests) {
        forgetAreas(bench, placed);
    }
    if (!rests && !judge_.busy() && seconds - lastSubmit_ >= kBetweenTasks && !placed.empty()) {
        const auto isQuick = [&](const PlacedPane& pane) {
            return bench.pane(pane.pane).judgedBy() == judge::TruthOf::centre;
        };
        if (bench.document().layout == picture::Layout::diff) {
            if (std::ranges::all_of(placed, isQuick))
                for (const PlacedPane& pane : placed)
                    wanted_.push_back(pane.pane);
        } else {
            turn_ = (turn_ + 1) % placed.size();
            if (canBeJudged(shown.requests[turn_]) && isQuick(placed[turn_])) wanted_.push_back(placed[turn_].pane);
        }
    }
    bench.wantVisibility(wanted_);
    return !wanted_.empty();
}

/// While something moves a verdict may be a moment old. It is not kept under the name of another technique or light, nor for another
/// scene, slide or lesson.
void LiveErrors::forgetOthers(const Workbench& bench, const std::vector<PlacedPane>& placed, const OnShow& shown) {
    if (std::exchange(replacements_, bench.replacements()) != bench.replacements()) {
        errors_.clear();
        pictures_.clear();
        difference_.reset();
        submitted_.clear();
        exactFor_ = {}; // the same may be shown again
    }
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const PaneRequest& request = shown.requests[i];
        const auto forgotten = std::erase_if(errors_, [&](const auto& known) {
            const PaneRequest& judged = known.second.judged;
            return known.first == placed[i].pane &&
                   (judged.state.technique != request.state.technique || judged.light != request.light);
        });
        if (forgotten > 0) exactFor_ = {};
    }
}

/// The truth about an area takes seconds. So while things move nothing is said of who is judged by it: what was true of another
/// picture might be wrong of this one.
void LiveErrors::forgetAreas(const Workbench& bench, const std::vector<PlacedPane>& placed) {
    for (const PlacedPane& pane : placed) {
        if (bench.pane(pane.pane).judgedBy() != judge::TruthOf::area) continue;
        errors_.erase(pane.pane);
        pictures_.erase(pane.pane);
        if (bench.document().layout == picture::Layout::diff) difference_.reset();
    }
}

bool LiveErrors::update(Workbench& bench, ivec2 areaSize, double seconds) {
    const std::vector<PlacedPane> placed = bench.placed(areaSize);
    if (!wanted_.empty()) {
        // A pane that could not be drawn in time is asked again in the next frame.
        const bool ready = std::ranges::all_of(wanted_, [&](int pane) {
            return !bench.pane(pane).failure().empty() || bench.pane(pane).visibility(bench.document().light);
        });
        const bool exact = seconds - restSince_ >= kRest;
        if (ready) {
            submit(bench, placed, wanted_, markWidthFor(areaSize, bench.draft()), exact);
            lastSubmit_ = seconds;
            if (exact) exactFor_ = onShow(bench, placed);
        }
    } else if (!isNew_ && seconds - restSince_ >= kRest && (exactFor_.requests.empty() || onShow(bench, placed) != exactFor_)) {
        done_ = true; // nothing on show can be judged
    }
    try {
        // The reduced answer of an exact task comes before its exact one, under the same number.
        std::shared_ptr<const JudgeAnswer> answer = judge_.newest();
        if (!answer || answer == taken_) return false;
        taken_ = std::move(answer);
        take(bench, *taken_, seconds);
        return true;
    } catch (const std::exception& fault) {
        failure_ = fault.what();
        done_ = true; // there will be no better answer
        return true;
    }
}

void LiveErrors::submit(Workbench& bench, const std::vector<PlacedPane>& placed, const std::vector<int>& panes,
                        int markWidth, bool exact) {
    const bool diff = bench.document().layout == picture::Layout::diff;
    JudgeTask task;
    Submitted submitted;
    submitted.markWidth = markWidth;
    for (const PlacedPane& one : placed) {
        if (std::ranges::find(panes, one.pane) == panes.end()) continue;
        const Pane& pane = bench.pane(one.pane);
        const PaneRequest& request = pane.drawnFor();
        const Stage* const answers = pane.visibility(request.light);
        if (!answers || !pane.failure().empty()) continue;
        task.snapshot = request.snapshot;
        task.view = request.view;
        task.light = request.light;
        const picture::StageRef& stage = request.state.stage;
        SlotTask slot;
        slot.region = request.view.region;
        slot.truth = pane.judgedBy();
        slot.visibility = picture::readVisibility(*answers, slot.region);
        slot.wantsOverlay = stage.isError();
        slot.markWidth = markWidth;
        task.wantsTruthPanel = task.wantsTruthPanel || stage.isTruth();
        if (stage.isJudged() && pane.picture().texture) {
            // The pane's own picture may be another one when the answer comes.
            submitted.grounds.emplace(one.pane, bench.encoder().copyOf(pane.picture().texture));
            if (stage.isScanline()) submitted.answers.emplace(one.pane, picture::readVisibility(*answers));
        }
        if (diff && submitted.panes.empty()) submitted.diffGround = bench.encoder().read(pane.picture().texture);
        task.slots.push_back(std::move(slot));
        submitted.panes.push_back(one.pane);
        submitted.requests.push_back(request);
    }
    if (task.slots.empty()) return;
    forgetAreas(bench, placed);
    task.exact = exact;
    if (exact) {
        bench.session().setScene(task.snapshot);
        task.rasterised = bench.session().rasterise(task.view);
    }
    const std::uint64_t number = judge_.submit(std::move(task));
    submitted_.emplace(number, std::move(submitted));
}

void LiveErrors::take(const Workbench& bench, const JudgeAnswer& answer, double seconds) {
    const auto found = submitted_.find(answer.number);
    if (found == submitted_.end()) return;
    Submitted& submitted = found->second;
    Sample sample{seconds, std::vector<SlotSample>(kPanes)};
    for (std::size_t i = 0; i < submitted.panes.size(); ++i) {
        const int pane = submitted.panes[i];
        if (!answer.slots[i]) continue;
        const SlotAnswer& slot = *answer.slots[i];
        errors_[pane] = {slot.judgement.counts, slot.edgeErrorPx, slot.coreErrors, slot.exact, submitted.requests[i]};
        showPicture(bench, answer, submitted, i);
    }
    for (int pane = 0; pane < kPanes; ++pane) {
        SlotSample& slot = sample.slots[static_cast<std::size_t>(pane)];
        slot.frameMs = bench.pane(pane).rendered().frameMs;
        if (const auto known = errors_.find(pane); known != errors_.end()) {
            slot.edgeErrorPx = known->second.edgeErrorPx;
            slot.wrongPixels = known->second.counts.wrong();
        }
    }
    history_.add(std::move(sample));
    if (submitted.diffGround && submitted.panes.size() == 2 && answer.slots[0] && answer.slots[1]) {
        const auto title = [&](std::size_t i) {
            return std::string(findTechnique(submitted.requests[i].state.technique).title);
        };
        const auto panel = [&](int markWidth) {
            return picture::differencePanel(*submitted.diffGround,
                                            {&answer.slots[0]->judgement, &answer.slots[1]->judgement}, {title(0), title(1)},
                                            markWidth);
        };
        picture::Panel marked = panel(submitted.markWidth);
        std::erase_if(marked.display.key, [](const KeyEntry& entry) { return entry.label.ends_with(": 0 px"); });
        difference_ = JudgedPicture{{},
                                    textureOf(marked.picture),
                                    textureOf(panel(picture::kOnePixel).picture),
                                    {{}, marked.kind, marked.display, ""},
                                    answer.exact};
    }
    done_ = answer.exact;
    // What is older than this answer will not be answered any more.
    std::erase_if(submitted_, [&](const auto& one) {
        return one.first < answer.number || (one.first == answer.number && answer.exact);
    });
}

void LiveErrors::showPicture(const Workbench&, const JudgeAnswer& answer, Submitted& submitted, std::size_t slot) {
    const int pane = submitted.panes[slot];
    const PaneRequest& request = submitted.requests[slot];
    const picture::StageRef& stage = request.state.stage;
    if (!stage.isJudged()) {
        pictures_.erase(pane);
        return;
    }
    const SlotAnswer& judged = *answer.slots[slot];
    const bool last = answer.exact; // else the same ground is needed once more
    JudgedPicture& shown = pictures_[pane];
    const auto ground = submitted.grounds.find(pane);
    const auto keep = [&](const picture::Panel& panel, bool overGround) {
        shown.verdicts = textureOf(panel.picture);
        if (overGround && ground != submitted.grounds.end()) {
            shown.ground = last ? std::move(ground->second) : picture::PictureEncoder::copyOf(ground->second);
        } else {
            shown.ground = {};
        }
        shown.legend = {{}, panel.kind, panel.display, ""};
        shown.onePixelEach = {};
        shown.exact = judged.exact;
    };
    if (stage.isError() && judged.overlay) {
        keep(*judged.overlay, true);
        if (judged.onePixelEach) shown.onePixelEach = textureOf(*judged.onePixelEach);
    }
    if (stage.isTruth() && judged.truthPanel) keep(*judged.truthPanel, false);
    if (stage.isScanline() && ground != submitted.grounds.end()) {
        const picture::Scanline scanline{*judged.truth, judged.judgement, submitted.answers[pane],
                                         request.snapshot->light(request.light).name,
                                         std::string(findTechnique(request.state.technique).title)};
        keep(picture::scanlinePanel(picture::PictureEncoder::read(ground->second), scanline, {}, request.view.region, &font_), false);
    }
}

const PaneErrors* LiveErrors::errors(int pane) const {
    const auto found = errors_.find(pane);
    return found == errors_.end() ? nullptr : &found->second;
}

const JudgedPicture* LiveErrors::shownOn(const Document& document, int pane) const {
    if (document.layout == picture::Layout::diff) return difference();
    return document.panes[static_cast<std::size_t>(pane)].stage.isJudged() ? picture(pane) : nullptr;
}

const JudgedPicture* LiveErrors::picture(int pane) const {
    const auto found = pictures_.find(pane);
    return found == pictures_.end() ? nullptr : &found->second;
}

} // namespace shadowlab::lab
