// Losing the display while its window is open: the X server ends, or the connection to it.
// SPDX-License-Identifier: MIT
#pragma once

namespace shadowlab::context {

/// From now on, when the connection to the X server is lost, the program ends with one line and the exit status of missing
/// graphics. Xlib alone would print a line of its own and exit(1). Does nothing without Xlib.
void endWhenDisplayIsGone();

/// The descriptor for that line, while standard error leads elsewhere.
void tellLossOfDisplayOn(int descriptor);

} // namespace shadowlab::context
