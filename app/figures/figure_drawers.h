// The figures, each in a file of its own; figures.cpp is the table of them.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/figures/figures.h"

namespace shadowlab::figures {

/// The segment from the pixel's point to the light, and what it meets.
Diagram drawShadowRay(const FigureSource& source);

// Of the tree of a pixel's rays.
Diagram drawPixelRay(const FigureSource& source);
Diagram drawPathsFigure(const FigureSource& source);
Diagram drawTreeFigure(const FigureSource& source);
Diagram drawVectorsFigure(const FigureSource& source);

// Of structures that accelerate ray tracing.
Diagram drawBoundingVolumes(const FigureSource& source);
Diagram drawGrid(const FigureSource& source);

// Of distributed ray tracing.
Diagram drawJitter(const FigureSource& source);
Diagram drawLens(const FigureSource& source);
Diagram drawGloss(const FigureSource& source);
Diagram drawTranslucency(const FigureSource& source);
Diagram drawLamp(const FigureSource& source);
Diagram drawPenumbra(const FigureSource& source);
Diagram drawShutter(const FigureSource& source);

// Of radiosity.
Diagram drawFormFactorFigure(const FigureSource& source);
Diagram drawReflectorFigure(const FigureSource& source);
Diagram drawEquations(const FigureSource& source);

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

/// P_L, P of the caster, its projection P' in the receiver's plane, and the plane's N.
Diagram drawProjection(const FigureSource& source);

/// The systems of coordinates of eye and light, the map, and the depths of the picked point.
Diagram drawCamerasFigure(const FigureSource& source);
/// The passes of a frame, and how many polygons each of them draws.
Diagram drawPassesFigure(const FigureSource& source);

} // namespace shadowlab::figures
