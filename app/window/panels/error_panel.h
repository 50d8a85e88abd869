// How wrong each pane is beside how long it takes, as numbers and as a plot over time.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/lab/errors/live_errors.h"
#include "app/window/desk.h"
#include "app/window/theme.h"

namespace shadowlab::window {

/// A row for each pane on show.
void errorTable(const Desk& desk, const lab::LiveErrors& errors);
/// Frame times above, edge errors below, one curve for each pane on show.
void historyPlot(const Desk& desk, const lab::LiveErrors& errors, const Theme& theme);

/// The colour that a pane's curve and its number in the table have.
ImU32 paneColor(int pane);

} // namespace shadowlab::window
