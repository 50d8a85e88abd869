// For one light point: the casters to flatten onto each plane, as lists to draw, and the part of the picture where the
// shadows can fall.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/planar/casters.h"
#include "techniques/planar/params.h"
#include "techniques/planar/receivers/receivers.h"

namespace shadowlab::planar {

/// A caster that is drawn on its own.
struct SingleCaster {
    std::size_t caster = 0;
    double contact = 0;
    bool frontsSuffice = false;
    std::vector<TriangleRun> runs; ///< of its mesh: all but the triangles that pass by the light
};

/// One receiver plane lit by one light point.
struct LitPlane {
    const ChosenReceiver* receiver = nullptr;
    Projection projection;
    /// The light point is behind the plane or in it: no point of the plane sees it.
    bool turnedAway = false;
    double contact = 0;                ///< metres, for all in the two lists; see contactHeight
    DrawList frontsSuffice;            ///< casters of which only the faces toward the light are drawn
    DrawList bothSides;                ///< casters of which both sides are drawn
    std::vector<SingleCaster> singles; ///< drawn one by one
    std::vector<dvec4> hiddenBehind;   ///< planes in world space: what is behind them is in shadow (NearTriangle)
    int casters = 0;                   ///< how many, in all three
    scene::PicturePart part;           ///< where shadows can fall
};

/// The planes that a point of that light (homogeneous, world space) casts shadows on, in the order of `receivers`. Planes whose
/// dark side faces the eye are left out, unless faces are drawn as in the lecture; with `countTurnedAway` they are listed
/// as turned away, for points of a light whose centre does shine on them.
std::vector<LitPlane> litPlanes(const scene::Scene& scene, const std::vector<ChosenReceiver>& receivers,
                                const Casters& casters, const gl::EyeMatrices& eye, const dvec4& lightWorld,
                                const scene::Light& light, const PlanarParams& params, bool countTurnedAway);

} // namespace shadowlab::planar
