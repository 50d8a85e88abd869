// The knobs of planar shadows: what receives, how a light with an area is sampled, and each safeguard, to be left out.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/params/param.h"
#include "techniques/foundation/scene/query/light_points.h"

namespace shadowlab::planar {

/// Stencil numbers of planes: six bits; two are for other things (technique.h).
constexpr int kNumbers = 63;

/// More planes than a teacher would want to draw everything onto.
constexpr int kMostReceivers = 1024;

struct PlanarParams {
    int receivers = 256;
    scene::LightPointParams lightPoints;
    bool clip = true;
    bool divide = false;
    bool stencil = true;
    double offset = 4;
    bool once = true;
    bool cull = true;
    friend bool operator==(const PlanarParams&, const PlanarParams&) = default;

    /// Faces that are drawn as lectures and papers first have it: they may fall outside their plane's pixels.
    [[nodiscard]] bool mayBeAnywhere() const { return !clip || !stencil || divide; }
};

/// The descriptions refer to the fields of `params`.
params::ParamList describe(PlanarParams& params);

} // namespace shadowlab::planar
