// How wrong each pane is beside how long it takes, as numbers and as a plot over time.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/session/live_errors.h"
#include "app/ui/desk.h"
#include "app/ui/theme.h"

namespace shadowlab::ui {

/// A row for each pane on show.
void errorTable(const Desk& desk, const session::LiveErrors& errors);
/// Frame times above, edge errors below, one curve for each pane on show.
void historyPlot(const Desk& desk, const session::LiveErrors& errors, const Theme& theme);

/// The colour that a pane's curve and its number in the table have.
ImU32 paneColor(int pane);

} // namespace shadowlab::ui
