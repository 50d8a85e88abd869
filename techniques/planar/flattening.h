// What one point of light flattens onto which planes: the lists that are drawn, and where in the picture it can fall.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/planar/caster_buffers.h"
#include "techniques/planar/params.h"
#include "techniques/planar/receivers.h"

namespace shadowlab::planar {

/// One plane under one point of light.
struct LitPlane {
    const ChosenReceiver* receiver = nullptr;
    Projection projection;
    /// The point of light is behind the plane, or in it: no point of the plane sees it.
    bool turnedAway = false;
    double contact = 0;               ///< metres, for all casters; see contactHeight
    DrawList frontsSuffice;           ///< of these the faces toward the light are enough
    DrawList bothSides;               ///< of these both sides are drawn
    std::vector<std::size_t> cutOuts; ///< casters with holes: drawn one by one
    int casters = 0;                  ///< in all three
    scene::PicturePart part;          ///< where shadows can fall
};

/// The planes that a point of light (homogeneous, world space) casts shadows on, in the order of `receivers`. Those that show the
/// eye their other side are left out, unless nothing is to be culled; `turnedAway` planes are listed only where
/// `countTurnedAway`, for points of a light whose centre shines on them.
std::vector<LitPlane> litPlanes(const std::vector<ChosenReceiver>& receivers, const std::vector<Caster>& casters,
                                const gl::EyeMatrices& eye, const dvec4& lightWorld, const PlanarParams& params,
                                bool countTurnedAway);

/// The smallest part that holds both.
scene::PicturePart around(const scene::PicturePart& a, const scene::PicturePart& b);

} // namespace shadowlab::planar
