// The parameters of radiosity.
// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "techniques/foundation/params/param.h"
#include "techniques/radiosity/solvers/solvers.h"

namespace shadowlab::radiosity {

struct RadiosityParams {
    // What form factors depend on.
    int patches = 600;
    bool importance = true; ///< to the picture
    bool cutAtContacts = true;
    int refine = 0; ///< rounds
    double refineThreshold = 0.05;
    enum class FormFactors { analytic, hemicube } formFactors = FormFactors::analytic;
    int hemicubeSide = 128;
    bool scaleRows = true;

    // What the solution depends on.
    enum class Surroundings { background, ambient, dark } surroundings = Surroundings::background;
    SolverKind solver = SolverKind::conjugateGradients;
    double tolerance = 1e-4;
    int steps = 0, stepsPerPicture = 0;
    bool ambientTerm = true;

    // How the solution is displayed.
    enum class Display { interpolated, flat } display = Display::interpolated;
    enum class Direct { pixels, lightMap, patches } direct = Direct::pixels; ///< not shown flat
    int lightMapPoints = 60000;
    enum class Gather { none, shared, pixels } gather = Gather::shared; ///< with direct light of pixels
    int gatherSamples = 128;
    [[nodiscard]] bool isFlat() const { return display == Display::flat; }
    [[nodiscard]] bool showsPixels() const { return !isFlat() && direct == Direct::pixels; }
    [[nodiscard]] bool gathers() const { return showsPixels() && gather != Gather::none; }
    double exposure = 0; ///< stops
    [[nodiscard]] double exposureFactor() const { return std::exp2(exposure); }
    int bounce = 2, fromPatch = -1, toPatch = -1;
    friend bool operator==(const RadiosityParams&, const RadiosityParams&) = default;
};

/// The descriptions refer to the fields of `params`.
params::ParamList describe(RadiosityParams& params);

} // namespace shadowlab::radiosity
