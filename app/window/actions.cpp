// SPDX-License-Identifier: MIT
#include "app/window/actions.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <utility>

#include <imgui.h>

#include "app/window/imgui_bridge.h"
#include "app/window/key_functions.h"

namespace shadowlab::window {

namespace {

template <std::size_t number>
constexpr Action techniqueKey(const char* id, const char* digit) {
    return {id,
            "Techniques and layout",
            digit,
            "the technique of that number, in the active pane",
            GLFW_KEY_0 + static_cast<int>(number),
            false,
            false,
            false,
            [](WindowState& d) { chooseNumber(d, number - 1); }};
}

const Action kActions[] = {
    techniqueKey<1>("technique-1", "1"),
    techniqueKey<2>("technique-2", "2"),
    techniqueKey<3>("technique-3", "3"),
    techniqueKey<4>("technique-4", "4"),
    techniqueKey<5>("technique-5", "5"),
    techniqueKey<6>("technique-6", "6"),
    techniqueKey<7>("technique-7", "7"),
    techniqueKey<8>("technique-8", "8"),
    techniqueKey<9>("technique-9", "9"),
    {"sister", "Techniques and layout", "Shift+L", "the lecture's version of the technique, and back", GLFW_KEY_L,
     false, true, false, [](WindowState& d) { chooseSister(d); }},
    {"next-pane", "Techniques and layout", "Tab", "the next pane is the active one", GLFW_KEY_TAB, false, false, false,
     [](WindowState& d) {
         const int count = std::max(2, lab::shownPanes(d.bench.document().layout));
         d.bench.activate((d.bench.document().active + 1) % count);
     }},
    {"next-layout", "Techniques and layout", "V", "single, side by side, split, grid, difference", GLFW_KEY_V, false,
     false, false, [](WindowState& d) { nextLayout(d, 1); }},
    {"previous-layout", "Techniques and layout", "Shift+V", "the layout before", GLFW_KEY_V, false, true, false,
     [](WindowState& d) { nextLayout(d, -1); }},
    {"split-left", "Techniques and layout", "[", "the split line goes left", GLFW_KEY_LEFT_BRACKET, false, false, true,
     [](WindowState& d) { moveSplit(d, -kSplitShare); }},
    {"split-right", "Techniques and layout", "]", "the split line goes right", GLFW_KEY_RIGHT_BRACKET, false, false,
     true, [](WindowState& d) { moveSplit(d, kSplitShare); }},
    {"blink", "Techniques and layout", "B", "blink: the first two panes take turns in one place", GLFW_KEY_B, false,
     false, false, [](WindowState& d) { d.shown.blink = !d.shown.blink; }},
    {"magnifier", "Techniques and layout", "M", "magnifier, at the same place in all panes", GLFW_KEY_M, false, false,
     false, [](WindowState& d) { d.shown.magnifier = !d.shown.magnifier; }},

    {"step-forward", "Steps and stages", "PageDown",
     "the next slide or part of the lesson that is on, else the next step of the algorithm", GLFW_KEY_PAGE_DOWN, false,
     false, true, [](WindowState& d) { goThroughStory(d, 1); }},
    {"step-forward-n", "Steps and stages", "N", "the next step of the algorithm", GLFW_KEY_N, false, false, true,
     [](WindowState& d) { goThroughSteps(d, 1); }},
    {"step-back", "Steps and stages", "PageUp", "the one before", GLFW_KEY_PAGE_UP, false, false, true,
     [](WindowState& d) { goThroughStory(d, -1); }},
    {"step-back-n", "Steps and stages", "Shift+N", "the step before", GLFW_KEY_N, false, true, true,
     [](WindowState& d) { goThroughSteps(d, -1); }},
    {"source", "Steps and stages", "Y", "formula, pseudocode and source of the step, beside its picture", GLFW_KEY_Y,
     false, false, false, toggleSource},
    {"source-on", "Steps and stages", "Shift+PageDown", "their text goes on", GLFW_KEY_PAGE_DOWN, false, true, true,
     [](WindowState& d) { ++d.requests.scrollSource; }},
    {"source-back", "Steps and stages", "Shift+PageUp", "their text goes back", GLFW_KEY_PAGE_UP, false, true, true,
     [](WindowState& d) { --d.requests.scrollSource; }},
    {"strip", "Steps and stages", "T", "all stages as small pictures", GLFW_KEY_T, false, false, false,
     [](WindowState& d) { d.shown.strip = !d.shown.strip; }},
    {"error", "Steps and stages", "E", "where the technique is wrong", GLFW_KEY_E, false, false, false,
     [](WindowState& d) { toggleStage(d, {"error"}); }},
    {"truth", "Steps and stages", "U", "the exact answer", GLFW_KEY_U, false, false, false,
     [](WindowState& d) { toggleStage(d, {"truth"}); }},
    {"outside", "Steps and stages", "O", "the second camera, which looks on from outside", GLFW_KEY_O, false, false,
     false, [](WindowState& d) { toggleStage(d, {"outside"}); }},
    {"pick", "Steps and stages", "X", "picks the pixel under the mouse: all that is known about it", GLFW_KEY_X, false,
     false, false, [](WindowState& d) { d.requests.pick = true; }},
    {"pick-partner", "Steps and stages", "Shift+X", "picks a second pixel: what radiosity's patches there exchange",
     GLFW_KEY_X, false, true, false, [](WindowState& d) { d.requests.pickPartner = true; }},
    {"next-light", "Steps and stages", "L", "stages and errors are about the next light", GLFW_KEY_L, false, false,
     false, nextLight},

    {"lesson-on", "Steps and stages", "J", "lessons: the artefact, its remedy, the next lesson", GLFW_KEY_J, false, false,
     false, [](WindowState& d) { stepLesson(d, 1); }},
    {"lesson-back", "Steps and stages", "Shift+J", "lessons: one step back", GLFW_KEY_J, false, true, false,
     [](WindowState& d) { stepLesson(d, -1); }},
    {"slide-on", "Steps and stages", "S", "slides: the next picture, and the next slide", GLFW_KEY_S, false, false,
     true, [](WindowState& d) { stepSlides(d, 1); }},
    {"slide-back", "Steps and stages", "Shift+S", "slides: one picture back", GLFW_KEY_S, false, true, true,
     [](WindowState& d) { stepSlides(d, -1); }},

    {"left", "Camera, lights and objects", "Left", "around to the left; or moves what is selected", GLFW_KEY_LEFT,
     false, false, true, [](WindowState& d) { arrows(d, -1, 0); }},
    {"right", "Camera, lights and objects", "Right", "around to the right", GLFW_KEY_RIGHT, false, false, true,
     [](WindowState& d) { arrows(d, 1, 0); }},
    {"up", "Camera, lights and objects", "Up", "over the scene; or moves away", GLFW_KEY_UP, false, false, true,
     [](WindowState& d) { arrows(d, 0, 1); }},
    {"down", "Camera, lights and objects", "Down", "under the scene; or moves nearer", GLFW_KEY_DOWN, false, false,
     true, [](WindowState& d) { arrows(d, 0, -1); }},
    {"pan-left", "Camera, lights and objects", "Shift+Left", "the camera goes left", GLFW_KEY_LEFT, false, true, true,
     [](WindowState& d) { pan(d, -kPanShare, 0); }},
    {"pan-right", "Camera, lights and objects", "Shift+Right", "the camera goes right", GLFW_KEY_RIGHT, false, true,
     true, [](WindowState& d) { pan(d, kPanShare, 0); }},
    {"lift", "Camera, lights and objects", "Shift+Up", "the camera, or what is selected, goes up", GLFW_KEY_UP, false,
     true, true, [](WindowState& d) { lift(d, 1); }},
    {"lower", "Camera, lights and objects", "Shift+Down", "it goes down", GLFW_KEY_DOWN, false, true, true,
     [](WindowState& d) { lift(d, -1); }},
    {"fly-left", "Camera, lights and objects", "Ctrl+Left", "flies left", GLFW_KEY_LEFT, true, false, true,
     [](WindowState& d) { fly(d, -1, 0); }},
    {"fly-right", "Camera, lights and objects", "Ctrl+Right", "flies right", GLFW_KEY_RIGHT, true, false, true,
     [](WindowState& d) { fly(d, 1, 0); }},
    {"fly-forward", "Camera, lights and objects", "Ctrl+Up", "flies forward", GLFW_KEY_UP, true, false, true,
     [](WindowState& d) { fly(d, 0, 1); }},
    {"fly-back", "Camera, lights and objects", "Ctrl+Down", "flies back", GLFW_KEY_DOWN, true, false, true,
     [](WindowState& d) { fly(d, 0, -1); }},
    {"nearer", "Camera, lights and objects", "+", "nearer", GLFW_KEY_EQUAL, false, false, true,
     [](WindowState& d) { zoom(d, kZoomFactor); }},
    {"farther", "Camera, lights and objects", "-", "farther", GLFW_KEY_MINUS, false, false, true,
     [](WindowState& d) { zoom(d, 1 / kZoomFactor); }},
    {"reset-camera", "Camera, lights and objects", "0", "the scene's own camera", GLFW_KEY_0, false, false, false,
     resetCamera},
    {"select-next", "Camera, lights and objects", "K", "selects the next light or object", GLFW_KEY_K, false, false,
     true, [](WindowState& d) { selectNext(d, 1); }},
    {"select-previous", "Camera, lights and objects", "Shift+K", "selects the one before", GLFW_KEY_K, false, true,
     true, [](WindowState& d) { selectNext(d, -1); }},
    {"handles", "Camera, lights and objects", "G", "handles of lights and objects", GLFW_KEY_G, false, false, false,
     [](WindowState& d) { d.shown.handles = !d.shown.handles; }},

    {"play", "Animation and scenes", "Space", "plays, pauses", GLFW_KEY_SPACE, false, false, false,
     [](WindowState& d) { d.bench.play(!d.bench.animation().playing); }},
    {"slower", "Animation and scenes", ",", "half as fast", GLFW_KEY_COMMA, false, false, false,
     [](WindowState& d) { changeSpeed(d, 0.5); }},
    {"faster", "Animation and scenes", ".", "twice as fast", GLFW_KEY_PERIOD, false, false, false,
     [](WindowState& d) { changeSpeed(d, 2); }},
    {"movers", "Animation and scenes", "A", "what moves: lights and objects, the camera, all", GLFW_KEY_A, false, false,
     false, nextMovers},
    {"next-scene", "Animation and scenes", "Ctrl+PageDown", "the next scene", GLFW_KEY_PAGE_DOWN, true, false, false,
     [](WindowState& d) { nextScene(d, 1); }},
    {"previous-scene", "Animation and scenes", "Ctrl+PageUp", "the scene before", GLFW_KEY_PAGE_UP, true, false, false,
     [](WindowState& d) { nextScene(d, -1); }},
    {"save-scene", "Animation and scenes", "Ctrl+S", "saves what is seen as a scene", GLFW_KEY_S, true, false, false,
     [](WindowState& d) { d.requests.saveScene = true; }},
    {"screenshot", "Animation and scenes", "P", "saves the picture, its command line, and the scene", GLFW_KEY_P, false,
     false, false, [](WindowState& d) { d.requests.screenshot = true; }},
    {"save-slide", "Animation and scenes", "W", "adds what is seen to slides.json, a deck for the command slides", GLFW_KEY_W,
     false, false, false, [](WindowState& d) { d.requests.saveSlide = true; }},

    {"keys", "Window", "H", "this list", GLFW_KEY_H, false, false, false, turnKeyPage},
    {"keys-f1", "Window", "F1", "this list", GLFW_KEY_F1, false, false, false, turnKeyPage},
    {"panel", "Window", "I", "settings, on and off", GLFW_KEY_I, false, false, false,
     togglePanel},
    {"focus-panel", "Window", "Enter", "into the settings: arrows choose, Space and Enter change, Esc leaves",
     GLFW_KEY_ENTER, false, false, false,
     [](WindowState& d) { d.shown.panel = d.requests.focusPanel = d.panelHasKeys = true; }},
    {"presenter", "Window", "D", "presenter mode: large type, high contrast", GLFW_KEY_D, false, false, false,
     togglePresenter},
    {"coarse", "Window", "C", "coarse pictures while it moves, where full ones come late", GLFW_KEY_C, false, false,
     false, [](WindowState& d) { d.shown.coarse = !d.shown.coarse; }},
    {"full-screen", "Window", "F", "full screen", GLFW_KEY_F, false, false, false,
     [](WindowState& d) { d.requests.fullScreen = true; }},
    {"full-screen-f11", "Window", "F11", "full screen", GLFW_KEY_F11, false, false, false,
     [](WindowState& d) { d.requests.fullScreen = true; }},
    {"undo", "Window", "Ctrl+Z", "takes the last change back", GLFW_KEY_Z, true, false, true,
     [](WindowState& d) { d.bench.undo(); }},
    {"redo", "Window", "Ctrl+Y", "makes it again", GLFW_KEY_Y, true, false, true,
     [](WindowState& d) { d.bench.redo(); }},
    {"reset-settings", "Window", "R", "the technique's own settings", GLFW_KEY_R, false, false, false, resetSettings},
    {"reload-shaders", "Window", "F5", "compiles all shaders anew", GLFW_KEY_F5, false, false, false,
     [](WindowState& d) { d.requests.reloadShaders = true; }},
    {"leave", "Window", "Esc",
     "out of a list, messages, the selection, the picked pixel, the lesson, the slides, the stage", GLFW_KEY_ESCAPE,
     false, false, false, leave},
    {"quit", "Window", "Ctrl+Q", "ends the program", GLFW_KEY_Q, true, false, false,
     [](WindowState& d) { d.requests.quit = true; }},
};

} // namespace

std::span<const Action> actions() { return kActions; }

namespace {

/// While the class paints where the shadow will be, nothing may show it, and no other stage or technique can be chosen.
bool waitsForTheAnswer(const WindowState& ui, const Action& action) {
    const std::string_view id = action.id, group = action.group;
    return ui.lesson.paints() && (group == "Steps and stages" || group == "Techniques and layout") &&
           !id.starts_with("lesson-") && id != "step-forward" && id != "step-back"; // these go through the lesson
}

/// While the right button holds the camera, these fly it (pictures.cpp), with Shift faster.
bool fliesTheCamera(const WindowState& ui, const KeyPress& press) {
    constexpr std::array kFlying = {GLFW_KEY_W, GLFW_KEY_A, GLFW_KEY_S, GLFW_KEY_D, GLFW_KEY_E, GLFW_KEY_Q};
    return ui.drag == Drag::camera && ImGui::IsMouseDown(1) && !press.ctrl && !press.alt &&
           std::ranges::find(kFlying, press.key) != kFlying.end();
}

} // namespace

std::vector<std::string> runKeys(WindowState& ui) {
    std::vector<std::string> ran;
    for (const KeyPress& press : std::exchange(ui.keys, {})) {
        if (ImGui::GetIO().WantTextInput || fliesTheCamera(ui, press)) continue;
        // An open list has the arrows; what commands the window waits until it is closed. One that the arrows went through closes by
        // itself at Esc, before this.
        if (isPopupOpen() || (ui.hadPopup && press.key == GLFW_KEY_ESCAPE)) {
            if (press.key == GLFW_KEY_ESCAPE) {
                if (isPopupOpen()) closePopups();
                ran.emplace_back("leave-popup");
            }
            continue;
        }
        if (ui.panelHasKeys && press.key == GLFW_KEY_ESCAPE) {
            ui.panelHasKeys = false;
            ImGui::SetWindowFocus(nullptr);
            ran.emplace_back("leave-panel");
            continue;
        }
        for (const Action& action : kActions) {
            const bool meant = action.key == press.key && action.ctrl == press.ctrl && action.shift == press.shift &&
                               !press.alt && (action.repeats || !press.repeated);
            // While the settings have the keyboard, what ImGui itself understands is theirs; Ctrl still commands the
            // window.
            if (!meant || (ui.panelHasKeys && !action.ctrl)) continue;
            if (waitsForTheAnswer(ui, action)) {
                ui.requests.news = "First the shadow is painted: J shows the truth, Esc leaves the lesson";
                continue;
            }
            if (!press.repeated) ui.bench.endGesture(); // a new press is a new change
            action.run(ui);
            ran.emplace_back(action.id);
        }
    }
    ui.hadPopup = isPopupOpen();
    return ran;
}

} // namespace shadowlab::window
