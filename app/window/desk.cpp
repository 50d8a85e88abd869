// SPDX-License-Identifier: MIT
#include "app/window/desk.h"

#include <algorithm>
#include <utility>

#include "app/lab/camera_control.h"
#include "app/picture/derived_stages.h"
#include "app/picture/steps/stepping.h"
#include "techniques/registry.h"

namespace shadowlab::window {

void chooseTechnique(Desk& desk, std::string_view id) {
    desk.bench.change("", [&](lab::Document& document) {
        lab::PaneState& state = document.panes[static_cast<std::size_t>(document.active)];
        if (state.technique == id) return;
        state.technique = id;
        // What is derived from any technique's picture stays on show; the stages are each technique's own.
        const auto known = picture::stagesOf(findTechnique(id));
        if (!state.stage.isDerived() || std::ranges::find(known, state.stage.id, &StageInfo::id) == known.end())
            state.stage = {};
    });
}

void chooseSister(Desk& desk) {
    const TechniqueInfo& shown = findTechnique(desk.bench.activeState().technique);
    if (const TechniqueInfo* sister = sisterOf(shown))
        chooseTechnique(desk, sister->id);
    else
        complain(desk, "the lecture has no version of '" + std::string(shown.title) + "'");
}

void chooseStage(Desk& desk, const picture::StageRef& stage) {
    desk.bench.change("stage", [&](lab::Document& document) {
        document.panes[static_cast<std::size_t>(document.active)].stage = stage;
    });
    desk.bench.endGesture();
}

void toggleStage(Desk& desk, const picture::StageRef& stage) {
    chooseStage(desk, desk.bench.activeState().stage == stage ? picture::StageRef() : stage);
}

void chooseLayout(Desk& desk, picture::Layout layout) {
    desk.bench.change("", [&](lab::Document& document) {
        document.layout = layout;
        if (layout != picture::Layout::single) document.active %= lab::shownPanes(layout);
    });
    desk.shown.blink = false;
}

void step(Desk& desk, int by) {
    const int active = desk.bench.document().active;
    const lab::Pane& pane = desk.bench.pane(active);
    const lab::PaneState& state = desk.bench.document().panes[static_cast<std::size_t>(active)];
    const scene::Scene& scene = *desk.bench.shownScene();
    chooseStage(desk, picture::stepped(state.stage, pane.passesOf(state.technique, scene), scene,
                                       desk.bench.document().light, by));
}

void moveSelected(Desk& desk, const dvec3& byWorld, const std::string& gesture) {
    desk.bench.changeScene(gesture, [&](const scene::Snapshot& before) {
        return lab::withMoved(before, desk.selection, byWorld, desk.bench.document().camera);
    });
}

void selectNext(Desk& desk, int by) {
    const scene::Scene& scene = *desk.bench.document().scene;
    std::vector<lab::Selection> all{{}};
    for (const lab::Handle& handle : lab::handles(scene, desk.bench.bounds(), desk.bench.document().camera))
        all.push_back(handle.what);
    const auto now = std::ranges::find(all, desk.selection);
    const auto count = static_cast<int>(all.size());
    const int at = now == all.end() ? 0 : static_cast<int>(now - all.begin());
    desk.selection = all[static_cast<std::size_t>((at + by + count) % count)];
}

void resetSettings(Desk& desk) {
    desk.bench.change("", [](lab::Document& document) {
        lab::PaneState& state = document.panes[static_cast<std::size_t>(document.active)];
        state.settings.erase(state.technique);
    });
}

void togglePresenter(Desk& desk) {
    desk.shown.presenter = !desk.shown.presenter;
    if (desk.shown.presenter)
        desk.panelOnDesk = std::exchange(desk.shown.panel, false);
    else
        desk.shown.panel = desk.panelOnDesk;
}

void toggleSource(Desk& desk) {
    desk.shown.source = !desk.shown.source;
    bool& panel =
        desk.shown.presenter ? desk.panelOnDesk : desk.shown.panel; // there the settings have made way already
    if (desk.shown.source)
        desk.panelBesideSource = std::exchange(panel, false);
    else
        panel = panel || desk.panelBesideSource;
}

void resetCamera(Desk& desk) {
    if (looksFromOutside(desk))
        desk.bench.resetOutsideCamera();
    else
        desk.bench.setCamera(desk.bench.document().scene->camera);
}

bool looksFromOutside(const Desk& desk) {
    const lab::Document& document = desk.bench.document();
    return document.panes[static_cast<std::size_t>(document.active)].stage.isOutside();
}

void moveCamera(Desk& desk, const std::function<scene::Camera(const scene::Camera&)>& move) {
    if (looksFromOutside(desk))
        desk.bench.setOutsideCamera(move(desk.bench.document().outsideCamera));
    else
        desk.bench.setCamera(move(desk.bench.document().camera));
}

void complain(Desk& desk, const std::string& fault) {
    std::erase_if(desk.messages, [&](const Message& message) { return message.text == fault; });
    constexpr int kMostFaults = 3;
    while (std::ranges::count_if(desk.messages, &Message::fault) >= kMostFaults)
        desk.messages.erase(std::ranges::find_if(desk.messages, &Message::fault));
    desk.messages.push_back({fault, true, 0});
}

} // namespace shadowlab::window
