// The parameters of planar shadows: what receives, how an area light is sampled, and a switch for each safeguard.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/params/param.h"
#include "techniques/foundation/scene/query/light_points.h"

namespace shadowlab::planar {

/// Stencil numbers of planes: six bits; the other two have other uses (technique.h).
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

    /// True if a safeguard is off: flattened faces may then fall outside of the pixels of their plane.
    [[nodiscard]] bool mayBeAnywhere() const { return !clip || !stencil || divide; }
};

/// The descriptions refer to the fields of `params`.
params::ParamList describe(PlanarParams& params);

} // namespace shadowlab::planar
