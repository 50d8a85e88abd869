// OpenGL without a driver behind it: what is left of a frame's time is the program's own.
// SPDX-License-Identifier: MIT
#pragma once

namespace shadowlab::speed {

/// From here on the calls of OpenGL that draw, set state and hand over data do nothing. What must be answered is still asked
/// of the driver: names of new objects, locations of uniforms, limits. To be called while a context is current, after the
/// frames that are to be drawn again; the driver is back once the context is made current again.
void silenceGl();

} // namespace shadowlab::speed
