// The widgets around the pictures: the bar on top, the panel beside them, the steps and the strip of stages below.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/window/desk.h"
#include "app/window/pictures.h"
#include "app/window/theme.h"

namespace shadowlab::window {

/// Begins an ImGui window that fills the area and stays there; ImGui::End() ends it. True while anything of it is seen.
bool beginIn(const char* name, const Area& area, ImGuiWindowFlags flags = 0);

// Each draws its window into the area it is given.
void topBar(Desk& desk, const Area& area, const Theme& theme);
void sidePanel(Desk& desk, const lab::LiveErrors& errors, const Area& area, const Theme& theme);
/// What the step that is on show does, and why.
void stepPanel(Desk& desk, const Area& area, const Theme& theme);

/// How high the bar and the panel of the steps are.
float topBarHeight(const Desk& desk, const Theme& theme, float width);
float stepPanelHeight(const Desk& desk, const Theme& theme, float width);

/// Is a step on show in the active pane?
bool isStepping(const Desk& desk);

} // namespace shadowlab::window
