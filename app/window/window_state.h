// The state of the window: the workbench, and how the window shows it. Keys and buttons change this and nothing else.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/lab/dragging.h"
#include "app/lab/workbench.h"
#include "app/window/lesson_state.h"
#include "app/window/slide_state.h"
#include "app/window/story.h"

namespace shadowlab::window {

/// What the window shows beside the pictures.
struct Shown {
    bool keys = false;   ///< the list of all keys
    bool panel = true;   ///< settings
    bool strip = false;  ///< stages as small pictures
    bool source = false; ///< the step on show as text: formula, pseudocode, source
    bool magnifier = false;
    bool blink = false; ///< the first two panes take turns in one place
    bool presenter = false;
    bool handles = true; ///< of lights and objects, for dragging
    bool plot = true;    ///< of times and errors
    bool coarse = true;  ///< fewer pixels while something moves, if all of them would take too long
    friend bool operator==(const Shown&, const Shown&) = default;
};

/// What a key or button requests and only the running window can do: it needs GLFW, a file, or some time.
struct Requests {
    bool quit = false, screenshot = false, saveScene = false, saveSlide = false, fullScreen = false,
         reloadShaders = false;
    bool focusPanel = false;
    int scrollSource = 0;                   ///< half pages of the step's text: on for more than zero, else back
    bool pick = false, pickPartner = false; ///< the pixel under the mouse, as the first or the second
    std::string scene;                      ///< to be loaded
    std::string news;                       ///< to be said over the pictures, for a while
};

/// A key that went down, or is held long enough to repeat. Letters are those on the keyboard's own layout.
struct KeyPress {
    int key = 0; ///< GLFW's number
    bool ctrl = false, shift = false, alt = false, repeated = false;
};

/// A sentence over the pictures. Faults stay until they are clicked away or their cause is gone, news disappear by themselves.
struct Message {
    std::string text;
    bool fault = false;
    double untilSeconds = 0; ///< on the screen's clock; faults ignore it
};

/// What the mouse holds.
enum class Drag { none, camera, splitLine, handle };

struct WindowState {
    lab::Workbench bench;
    Shown shown;
    Requests requests;
    std::vector<Message> messages;
    bool hadPopup = false; ///< a list was open when keys were last run
    std::vector<KeyPress> keys; ///< since the last frame, in order, so that none is lost
    std::set<int> heldKeys;     ///< keys that are down, numbered as KeyPress does
    lab::Selection selection, hovered;
    LessonState lesson;
    SlideState slides;
    InnerSteps innerSteps; ///< of a lesson or a slide
    dvec2 lens{
        0.5}; ///< where the magnifier looks, as shares of a picture's width and height from its upper left corner
    Drag drag = Drag::none;
    lab::Hold held;   ///< of the thing that is dragged,
    int dragPane = 0; ///< and the pane it is dragged in
    std::vector<std::string> scenes; ///< built-in ones
    bool live = true; ///< false for pictures of the window: no times, which differ from run to run, and exact errors at once
    bool showsTimes = true; ///< milliseconds, which differ from run to run: without them equal states have equal pictures
    bool panelOutsidePresenter = true; ///< whether the settings come back after presenter mode
    bool panelBesideSource = true;     ///< whether they come back after the source was on show
    int keyPage = 0, keyPages = 1;     ///< of the list of all keys: which is shown, and how many there are
    bool panelHasKeys = false;         ///< the arrow keys move among the settings instead of moving the camera

    // Where the mouse was pressed since the last frame (when the frame is drawn it may be elsewhere), and where it was when what it
    // drags was last moved. Pixels of the window.
    std::optional<dvec2> pressedAt;
    dvec2 heldAt{0.0};
    double flashUntil = 0; ///< the current light's handle flashes until then, on ImGui's clock

    explicit WindowState(lab::Document document) : bench(std::move(document)) {}
};

// What more than one key or button does.

/// The technique of the active pane. Its settings are those it had there before.
void chooseTechnique(WindowState& ui, std::string_view id);
/// The lecture's version of the active pane's technique, or back from it to the one that refines it.
void chooseSister(WindowState& ui);
/// What the active pane shows of its technique.
void chooseStage(WindowState& ui, const picture::StageRef& stage);
/// What the active pane shows, as a key or the view's list asks for it. A difference is always of finished pictures: it gives way to
/// the split picture, whose panes show stages.
void chooseView(WindowState& ui, const picture::StageRef& stage);
/// Shows that stage; or the finished picture, if the pane shows the stage already.
void toggleStage(WindowState& ui, const picture::StageRef& stage);
void chooseLayout(WindowState& ui, picture::Layout layout);
void step(WindowState& ui, int by);
/// Moves the selected object or light; for a directional light, the point at the end of its arrow.
void moveSelected(WindowState& ui, const dvec3& byWorld, const std::string& gesture);
void selectNext(WindowState& ui, int by);
void resetSettings(WindowState& ui);
/// Presenter mode with its large type hides the settings, for room; leaving it shows them again.
void togglePresenter(WindowState& ui);
/// Formula, pseudocode and source of the step, in the place of the settings.
void toggleSource(WindowState& ui);
/// The panel beside the pictures, with the settings or with the source.
void togglePanel(WindowState& ui);
void resetCamera(WindowState& ui);
/// Whether the active pane looks through the second camera, which is then the one that is moved.
bool looksFromOutside(const WindowState& ui);
void moveCamera(WindowState& ui, const std::function<scene::Camera(const scene::Camera&)>& move);

/// Shows a fault as a message, only once. At most three faults are shown, so that the picture below stays visible: older ones go.
void complain(WindowState& ui, const std::string& fault);

} // namespace shadowlab::window
