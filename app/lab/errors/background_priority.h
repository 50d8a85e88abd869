// Low priority for threads that must not delay the drawing.
// SPDX-License-Identifier: MIT
#pragma once

namespace shadowlab::lab {

/// Of Linux' scheduler: beside a thread of the usual priority, 0, this one gets a tenth of a processor. Idle priority would get nothing
/// at all while another program computes (a second window, a recorder of the screen), and the verdicts would never come.
inline constexpr int kBackgroundNice = 10;

/// Gives the calling thread, and each thread that it starts, that priority. On other systems, and where the call fails, nothing changes.
void yieldToDrawing();

} // namespace shadowlab::lab
