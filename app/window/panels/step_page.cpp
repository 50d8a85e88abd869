// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/picture/steps/stepping.h"
#include "app/window/panels/story_page.h"
#include "techniques/registry.h"

namespace shadowlab::window {

namespace {

StoryPage pageOf(const WindowState& ui, const TechniqueInfo& info, const PassInfo& pass) {
    StoryPage page;
    page.title = pass.title;
    page.lines.push_back({.text = std::string(pass.why)});
    if (!pass.glState.empty())
        page.lines.push_back({.kind = StoryLine::Kind::quiet, .text = "GL state: " + std::string(pass.glState)});
    const std::string pseudocode = pseudocodeOf(info, pass);
    if (ui.shown.source) return page; // there it stands with the source
    std::size_t indentation = pseudocode.size();
    for (std::size_t from = 0; from < pseudocode.size();) {
        const std::size_t end = std::min(pseudocode.find('\n', from), pseudocode.size());
        page.code.push_back({pseudocode.substr(from, end - from), true});
        indentation = std::min(indentation, page.code.back().text.find_first_not_of(' '));
        from = end + 1;
    }
    for (CodeLine& line : page.code) // what all lines are indented by says nothing
        line.text.erase(0, indentation);
    return page;
}

} // namespace

std::vector<StoryPage> stepPages(const WindowState& ui) {
    const TechniqueInfo& info = findTechnique(ui.bench.activeState().technique);
    std::vector<StoryPage> pages;
    for (const PassInfo& pass : info.passes)
        pages.push_back(pageOf(ui, info, pass));
    return pages;
}

StoryPage stepPage(const WindowState& ui) {
    const lab::PaneState& state = ui.bench.activeState();
    const lab::Document& document = ui.bench.document();
    const lab::Pane& pane = ui.bench.pane(document.active);
    const scene::Scene& scene = *ui.bench.shownScene();
    const std::vector<StageKey>& passes = pane.passesOf(state.technique, scene);
    const auto now = picture::stepOf(state.stage, passes, scene, document.light);
    if (!now) {
        // The list of steps is complete only after a frame was drawn; in a window without room for a picture none is.
        StoryPage page;
        page.title = passes.empty() ? "Nothing has been drawn yet" : "This step does not run with these settings";
        page.lines.push_back({.text = passes.empty() ? "The window has no room for a picture."
                                                     : "PageDown goes to the first step that does."});
        return page;
    }
    const TechniqueInfo& info = findTechnique(state.technique);
    StoryPage page = pageOf(ui, info, passInfo(info.passes, passes[*now].id));
    page.place = "Step " + std::to_string(*now + 1) + " of " + std::to_string(passes.size());
    const int light = passes[*now].light;
    if (light != kNoLight && scene.lights.size() > 1) page.place += ", light " + scene.light(light).name;
    if (!pane.picture().note.empty())
        page.lines.insert(page.lines.begin(), {.text = "The picture is " + pane.picture().note + "."});
    return page;
}

} // namespace shadowlab::window
