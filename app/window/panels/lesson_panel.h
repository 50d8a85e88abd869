// The words of a lesson: a strip below the pictures, and the list to choose from.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/window/desk.h"
#include "app/window/pictures.h"
#include "app/window/theme.h"

namespace shadowlab::window {

/// How high the strip is: room for the wordiest of the lesson's steps, so that pictures do not jump. 0 without a lesson.
float lessonPanelHeight(const Desk& desk, const Theme& theme, float width);
/// Title, step, and what is said about it.
void lessonPanel(Desk& desk, const Area& area, const Theme& theme);
/// All lessons of the course, to choose from.
void lessonList(Desk& desk);

} // namespace shadowlab::window
