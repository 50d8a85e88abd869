// What single keys do. What keys and buttons have in common stands in window_state.h.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/window/window_state.h"

namespace shadowlab::window {

// Steps of the keys, small enough to aim and large enough to get about. A held key repeats some 30 times a second.
constexpr double kPanShare = 0.04, kZoomFactor = 0.92, kSplitShare = 0.02;

/// The technique of that number in the active pane, counted from 0; while a lesson asks, its answer of that number.
void chooseNumber(WindowState& ui, std::size_t number);

// Of the active pane's camera. `right`, `up` and `forward`: 1 or -1, or 0; for pan a share of the picture's height.
void pan(WindowState& ui, double right, double up);
void fly(WindowState& ui, double right, double forward);
void zoom(WindowState& ui, double factor);

/// With something selected the arrows move it, parallel to the ground and as the camera sees it; else the camera orbits.
void arrows(WindowState& ui, double right, double forward);
/// With something selected it goes up or down; else the camera does.
void lift(WindowState& ui, double up);

void moveSplit(WindowState& ui, double by);
void nextLayout(WindowState& ui, int by);
void nextScene(WindowState& ui, int by);
void nextLight(WindowState& ui);
void changeSpeed(WindowState& ui, double factor);
/// What moves: lights and objects, the camera alone, all of them, and around again.
void nextMovers(WindowState& ui);
/// Opens the list of keys; or its next page, and after the last one closes it.
void turnKeyPage(WindowState& ui);
/// Leaves one thing, the nearest first: the list of keys, messages of faults, the selection, picked pixels, a lesson, a deck, a stage.
void leave(WindowState& ui);

} // namespace shadowlab::window
