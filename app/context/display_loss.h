// The display may go while its window is open: the X server ends, or the connection to it.
// SPDX-License-Identifier: MIT
#pragma once

namespace shadowlab::context {

/// From now on the program ends with one line and the status of missing graphics when the X server has gone. Xlib alone
/// would print a line of its own and exit(1). Does nothing without Xlib.
void endWhenDisplayIsGone();

/// The descriptor for that line, while standard error leads elsewhere.
void tellLossOfDisplayOn(int descriptor);

} // namespace shadowlab::context
