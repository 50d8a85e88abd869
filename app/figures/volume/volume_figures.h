// The lecture's figures of how a shadow volume is made, each of the caster that the pixel shows, or that shadows it.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/figures/figures.h"

namespace shadowlab::figures {

/// N, L and the sign of N.L of the pixel's polygon, and of one on the other side.
Diagram drawPolygonFigure(const FigureSource& source);
/// The outline edge nearest to the pixel with the two polygons that share it, and an edge that is no outline.
Diagram drawEdgeFigure(const FigureSource& source);
/// P_L, P and P' of a vertex of the outline.
Diagram drawExtrusionFigure(const FigureSource& source);
/// The whole volume, and where it cuts other objects.
Diagram drawVolumeFigure(const FigureSource& source);

/// The line that z-pass or z-fail follows, the faces on it, n_f and n_b.
Diagram drawCountFigure(const FigureSource& source);

/// The sides between the eye and the pixel, +1 or -1, and the polygon that the pixel shows.
Diagram drawPlusOneFigure(const FigureSource& source);

} // namespace shadowlab::figures
