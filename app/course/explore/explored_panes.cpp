// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/course/explore/explored_slide.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"

namespace shadowlab::course {

namespace {

constexpr std::size_t kMostPanes = 2; ///< on either side of a line

bool isOfFirstScene(const SlidePicture& picture, const SlidePicture& first) {
    return picture.state.sceneName == first.state.sceneName && picture.state.camera == first.state.camera &&
           picture.state.scene->lights == first.state.scene->lights && picture.state.light == first.state.light;
}

/// Can it be looked at as a view of its own? The finished picture and the verdicts always can, and passes are steps.
bool isView(const picture::StageRef& stage) { return !stage.isPicture() && !stage.isPass && !stage.isJudged() && !stage.isOutside(); }

} // namespace

std::vector<ExploredPane> panesOf(const Slide& slide, const Explore& explore) {
    std::vector<ExploredPane> panes;
    if (slide.pictures.empty())
        throw Error(ExitStatus::badInput, R"(shows no scene, so nothing of it can be explored; write "slots", or leave "explore" out)");
    const SlidePicture& first = slide.pictures.front();
    for (const SlidePicture& picture : slide.pictures) {
        if (!isOfFirstScene(picture, first)) continue;
        for (const lab::PaneState& slot : picture.state.slots) {
            ExploredPane pane{{slot.technique, {}, slot.settings}, {}};
            auto place = std::ranges::find(panes, pane.state, &ExploredPane::state);
            if (place == panes.end()) {
                if (panes.size() == kMostPanes) continue;
                place = panes.insert(panes.end(), std::move(pane));
            }
            if (isView(slot.stage) && std::ranges::find(place->stages, slot.stage) == place->stages.end())
                place->stages.push_back(slot.stage);
        }
    }
    for (const std::string& text : explore.stages) {
        const picture::StageRef stage = picture::StageRef::parse(text);
        std::string why;
        bool isFound = false;
        for (ExploredPane& pane : panes) {
            try {
                (void)picture::resolve(stage, findTechnique(pane.state.technique), *first.state.scene, first.state.light);
            } catch (const Error& error) {
                if (why.empty()) why = error.what();
                continue;
            }
            isFound = true;
            if (isView(stage) && std::ranges::find(pane.stages, stage) == pane.stages.end()) pane.stages.push_back(stage);
        }
        if (!isFound) throw Error(ExitStatus::badInput, "explore: " + why);
    }
    std::vector<std::string> shown;
    for (const ExploredPane& pane : panes)
        shown.push_back(pane.state.technique);
    for (const ExploredSetting& setting : explore.settings)
        if (std::ranges::find(shown, setting.technique) == shown.end())
            throw Error(ExitStatus::badInput, "explore: \"" + setting.technique + "." + setting.param +
                                                  "\" is of a technique that the slide does not show; " +
                                                  suggestion(setting.technique, shown));
    if (explore.task && explore.task->pane >= static_cast<int>(panes.size()))
        throw Error(ExitStatus::badInput, "explore: the task is about picture 2, and the slide has one technique; leave \"picture\" out");
    return panes;
}

} // namespace shadowlab::course
