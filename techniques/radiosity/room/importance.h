// What matters to the picture: how much of the light that leaves a surface comes to what the eye sees.
//
// The eye sends out importance as a lamp sends light, and surfaces reflect it: a patch that receives little of it may be wrong and nobody
// sees it (B. Smits, J. Arvo and D. Salesin, "An Importance-Driven Radiosity Algorithm", SIGGRAPH 1992). There it is the solution of a second
// system of equations, for patches that exist. Here it decides how large patches are, so paths from the eye find it before there are any. Half
// of them go through the picture, half of them anywhere, so that a turn of the head changes little. Where a path first meets a surface the pixel
// gathers light for itself; the next surfaces are those it gathers from.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/radiosity/patches/patches.h"
#include "techniques/radiosity/room/eye.h"
#include "techniques/radiosity/room/sides.h"

namespace shadowlab::radiosity {

class Importance {
public:
    /// Everything matters alike.
    Importance() = default;
    /// Of the sides that exchange light; of a ground distance decides (ground.h). In scenes where nearly everything matters, it is left out.
    Importance(const trace::SceneTracer& tracer, const Sides& sides, const Ground& ground, const Eye& eye);

    /// By which such sides are cut; empty: everything matters alike.
    [[nodiscard]] const FaceParts& parts() const { return parts_; }
    /// The share of the area of these sides that is cut more coarsely, 0..1.
    [[nodiscard]] double shareOfCoarse() const { return shareOfCoarse_; }
    /// Are sides of the same scene cut alike by both?
    [[nodiscard]] bool cutsLike(const Importance& other) const;

private:
    FaceParts parts_;
    double shareOfCoarse_ = 0;
};

} // namespace shadowlab::radiosity
