// What hands have before them: the workbench, and how the window shows it. Keys and buttons change this and nothing else.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/lab/handles.h"
#include "app/lab/workbench.h"
#include "app/window/lesson_state.h"
#include "app/window/slide_state.h"

namespace shadowlab::window {

/// What the window shows beside the pictures.
struct Shown {
    bool keys = false;   ///< the list of all keys
    bool panel = true;   ///< settings
    bool strip = false;  ///< stages as small pictures
    bool source = false; ///< the step at hand as text: formula, pseudocode, source
    bool magnifier = false;
    bool blink = false; ///< the first two panes take turns in one place
    bool presenter = false;
    bool handles = true; ///< of lights and objects, to be dragged
    bool plot = true;    ///< of times and errors
    bool coarse = true;  ///< fewer pixels while something moves, where all of them would come too late
    friend bool operator==(const Shown&, const Shown&) = default;
};

/// What the desk cannot do itself: it takes a window, a file or some time. Whoever runs the desk takes them.
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

/// A sentence over the pictures. Faults stay until they are clicked away or mended, news go by themselves.
/// What goes wrong is told at the top of the window; the picture has to be seen below, so older messages give way.
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
    std::vector<KeyPress> keys; ///< since the last frame, in order: none is lost, however quick the hand
    std::set<int> held;         ///< keys that are down, numbered as KeyPress does
    lab::Selection selection, hovered;
    LessonState lesson;
    SlideState slides;
    dvec2 lens{
        0.5}; ///< where the magnifier looks, as shares of a picture's width and height from its upper left corner
    Drag drag = Drag::none;
    int dragPart = -1, dragPane = 0; ///< of the handle that is held: an axis, or -1 for its disc; and where
    std::vector<std::string> scenes; ///< built-in ones
    bool live = true; ///< hands are at it. Else: no times, which are never the same twice, and exact errors at once
    bool panelOutsidePresenter = true; ///< whether the settings come back after presenter mode
    bool panelBesideSource = true;     ///< whether they come back after the source was on show
    bool panelHasKeys = false;         ///< the arrows walk through the settings, and not around the scene

    // Where the mouse went down since the last frame: a quick hand is elsewhere by the time the frame is drawn. And where
    // it was when what it holds was last moved. Pixels of the window.
    std::optional<dvec2> pressedAt;
    dvec2 heldAt{0.0};

    explicit WindowState(lab::Document document) : bench(std::move(document)) {}
};

// What more than one key or button does.

/// The technique of the active pane. Its settings are those it had there before.
void chooseTechnique(WindowState& ui, std::string_view id);
/// The lecture's version of the active pane's technique, or back from it to the one that refines it.
void chooseSister(WindowState& ui);
/// What the active pane shows of its technique.
void chooseStage(WindowState& ui, const picture::StageRef& stage);
/// That, or the finished picture where the pane shows it already.
void toggleStage(WindowState& ui, const picture::StageRef& stage);
void chooseLayout(WindowState& ui, picture::Layout layout);
void step(WindowState& ui, int by);
/// Where the selected thing is, or the point at which the arrow of a directional light is held.
void moveSelected(WindowState& ui, const dvec3& byWorld, const std::string& gesture);
void selectNext(WindowState& ui, int by);
void resetSettings(WindowState& ui);
/// Large type leaves less room: the settings make way for it, and come back with it gone.
void togglePresenter(WindowState& ui);
/// Formula, pseudocode and source of the step need room, too.
void toggleSource(WindowState& ui);
void resetCamera(WindowState& ui);
/// Which of the two cameras the active pane looks through, and hands move.
bool looksFromOutside(const WindowState& ui);
void moveCamera(WindowState& ui, const std::function<scene::Camera(const scene::Camera&)>& move);

/// Tells of a fault, once.
void complain(WindowState& ui, const std::string& fault);

} // namespace shadowlab::window
