// SPDX-License-Identifier: MIT
#include "app/window/window_state.h"

#include <algorithm>
#include <utility>

#include "app/lab/camera_control.h"
#include "app/picture/derived_stages.h"
#include "app/picture/steps/stepping.h"
#include "techniques/registry.h"

namespace shadowlab::window {

void chooseTechnique(WindowState& ui, std::string_view id) {
    ui.bench.change("", [&](lab::Document& document) {
        lab::PaneState& state = document.panes[static_cast<std::size_t>(document.active)];
        if (state.technique == id) return;
        state.technique = id;
        // What is derived from any technique's picture stays on show; the stages are each technique's own.
        const auto known = picture::stagesOf(findTechnique(id));
        if (!state.stage.isDerived() || std::ranges::find(known, state.stage.id, &StageInfo::id) == known.end())
            state.stage = {};
    });
}

void chooseSister(WindowState& ui) {
    const TechniqueInfo& shown = findTechnique(ui.bench.activeState().technique);
    if (const TechniqueInfo* sister = sisterOf(shown))
        chooseTechnique(ui, sister->id);
    else
        complain(ui, "the lecture has no version of '" + std::string(shown.title) + "'");
}

void chooseStage(WindowState& ui, const picture::StageRef& stage) {
    ui.bench.change("stage", [&](lab::Document& document) {
        document.panes[static_cast<std::size_t>(document.active)].stage = stage;
    });
    ui.bench.endGesture();
}

void chooseView(WindowState& ui, const picture::StageRef& stage) {
    if (ui.bench.document().layout == picture::Layout::diff && !stage.isPicture()) chooseLayout(ui, picture::Layout::split);
    chooseStage(ui, stage);
}

void toggleStage(WindowState& ui, const picture::StageRef& stage) {
    const bool isShown = ui.bench.activeState().stage == stage && ui.bench.document().layout != picture::Layout::diff;
    chooseView(ui, isShown ? picture::StageRef() : stage);
}

void chooseLayout(WindowState& ui, picture::Layout layout) {
    ui.bench.change("", [&](lab::Document& document) {
        document.layout = layout;
        if (layout != picture::Layout::single) document.active %= lab::shownPanes(layout);
    });
    ui.shown.blink = false;
}

void step(WindowState& ui, int by) {
    const lab::Pane& pane = ui.bench.pane(ui.bench.document().active);
    const lab::PaneState& state = ui.bench.activeState();
    const scene::Scene& scene = *ui.bench.shownScene();
    chooseView(
        ui, picture::stepped(state.stage, pane.passesOf(state.technique, scene), scene, ui.bench.document().light, by));
}

void moveSelected(WindowState& ui, const dvec3& byWorld, const std::string& gesture) {
    ui.bench.changeScene(gesture, [&](const scene::Snapshot& before) {
        return lab::withMoved(before, ui.selection, byWorld, ui.bench.document().camera);
    });
}

void selectNext(WindowState& ui, int by) {
    const scene::Scene& scene = *ui.bench.document().scene;
    std::vector<lab::Selection> all{{}};
    for (const lab::Handle& handle : lab::handles(scene, ui.bench.bounds(), ui.bench.document().camera))
        all.push_back(handle.what);
    const auto now = std::ranges::find(all, ui.selection);
    const auto count = static_cast<int>(all.size());
    const int at = now == all.end() ? 0 : static_cast<int>(now - all.begin());
    ui.selection = all[static_cast<std::size_t>((at + by + count) % count)];
}

void resetSettings(WindowState& ui) {
    ui.bench.change("", [](lab::Document& document) {
        lab::PaneState& state = document.panes[static_cast<std::size_t>(document.active)];
        state.settings.erase(state.technique);
    });
}

void togglePresenter(WindowState& ui) {
    ui.shown.presenter = !ui.shown.presenter;
    if (ui.shown.presenter)
        ui.panelOutsidePresenter = std::exchange(ui.shown.panel, false);
    else
        ui.shown.panel = ui.panelOutsidePresenter;
}

void toggleSource(WindowState& ui) {
    ui.shown.source = !ui.shown.source;
    bool& panel =
        ui.shown.presenter ? ui.panelOutsidePresenter : ui.shown.panel; // there the settings have made way already
    if (ui.shown.source)
        ui.panelBesideSource = std::exchange(panel, false);
    else
        panel = panel || ui.panelBesideSource;
}

void togglePanel(WindowState& ui) {
    if (ui.shown.source)
        toggleSource(ui);
    else
        ui.shown.panel = !ui.shown.panel;
}

void resetCamera(WindowState& ui) {
    if (looksFromOutside(ui))
        ui.bench.resetOutsideCamera();
    else
        ui.bench.setCamera(ui.bench.document().scene->camera);
}

bool looksFromOutside(const WindowState& ui) {
    return ui.bench.document().layout != picture::Layout::diff && // its picture is that of the eye
           ui.bench.activeState().stage.isOutside();
}

void moveCamera(WindowState& ui, const std::function<scene::Camera(const scene::Camera&)>& move) {
    if (looksFromOutside(ui))
        ui.bench.setOutsideCamera(move(ui.bench.document().outsideCamera));
    else
        ui.bench.setCamera(move(ui.bench.document().camera));
}

void complain(WindowState& ui, const std::string& fault) {
    std::erase_if(ui.messages, [&](const Message& message) { return message.text == fault; });
    constexpr int kMostFaults = 3;
    while (std::ranges::count_if(ui.messages, &Message::fault) >= kMostFaults)
        ui.messages.erase(std::ranges::find_if(ui.messages, &Message::fault));
    ui.messages.push_back({fault, true, 0});
}

} // namespace shadowlab::window
