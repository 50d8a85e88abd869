// The figures, each in a file of its own; figures.cpp is the table of them.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/figures/figures.h"

namespace shadowlab::figures {

// Of the tree of a pixel's rays.
Diagram drawPixelRay(const FigureSource& source);
Diagram drawPathsFigure(const FigureSource& source);
Diagram drawTreeFigure(const FigureSource& source);
Diagram drawVectorsFigure(const FigureSource& source);

// Of what spares rays their work.
Diagram drawBoundingVolumes(const FigureSource& source);
Diagram drawGrid(const FigureSource& source);

// Of rays that are spread.
Diagram drawJitter(const FigureSource& source);
Diagram drawLens(const FigureSource& source);
Diagram drawGloss(const FigureSource& source);
Diagram drawTranslucency(const FigureSource& source);
Diagram drawLamp(const FigureSource& source);
Diagram drawPenumbra(const FigureSource& source);
Diagram drawShutter(const FigureSource& source);

// Of patches that send each other light.
Diagram drawFormFactorFigure(const FigureSource& source);
Diagram drawReflectorFigure(const FigureSource& source);
Diagram drawEquations(const FigureSource& source);

} // namespace shadowlab::figures
