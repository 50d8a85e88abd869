// What one point of light flattens onto which planes: the lists that are drawn, and where in the picture it can fall.
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

/// One plane under one point of light.
struct LitPlane {
    const ChosenReceiver* receiver = nullptr;
    Projection projection;
    /// The point of light is behind the plane, or in it: no point of the plane sees it.
    bool turnedAway = false;
    double contact = 0;                ///< metres, for all in the two lists; see contactHeight
    DrawList frontsSuffice;            ///< of these the faces toward the light are enough
    DrawList bothSides;                ///< of these both sides are drawn
    std::vector<SingleCaster> singles; ///< drawn one by one
    std::vector<dvec4> hiddenBehind;   ///< planes in world space: what is behind them is in shadow (NearTriangle)
    int casters = 0;                   ///< how many, in all three
    scene::PicturePart part;           ///< where shadows can fall
};

/// The planes that a point of light (homogeneous, world space) casts shadows on, in the order of `receivers`. Those that show the
/// eye their other side are left out, unless faces are drawn as lectures have it; `countTurnedAway`: they are listed as such,
/// for points of a light whose centre shines on them.
std::vector<LitPlane> litPlanes(const scene::Scene& scene, const std::vector<ChosenReceiver>& receivers,
                                const Casters& casters, const gl::EyeMatrices& eye, const dvec4& lightWorld,
                                const PlanarParams& params, bool countTurnedAway);

/// Holds nothing.
inline constexpr scene::PicturePart kNowhere{dvec2(1.0), dvec2(-1.0)};

/// The smallest part that holds both.
scene::PicturePart around(const scene::PicturePart& a, const scene::PicturePart& b);

} // namespace shadowlab::planar
