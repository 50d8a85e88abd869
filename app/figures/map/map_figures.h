// The lecture's figures of shadow maps.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/figures/figures.h"

namespace shadowlab::figures {

/// The systems of coordinates of eye and light, the map, and the depths of the picked point.
Diagram drawCamerasFigure(const FigureSource& source);
/// The passes of a frame, and how many polygons each of them draws.
Diagram drawPassesFigure(const FigureSource& source);

} // namespace shadowlab::figures
