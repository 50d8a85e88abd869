// Fitting a light's cameras to what they are for: the casters that matter, and the receivers that are in view.
//
// A shadow falls along the light's rays, and along a ray nothing moves in the map. So a map need only hold, sideways, what
// casters and receivers have in common; in depth, the receivers alone: what is nearer to the light is clamped to the near
// plane and still in front of all of them ("pancaking").
//   directional  one parallel camera, or cascades (cascades.h), each perhaps warped (light_space_perspective.h)
//   spot         one perspective camera within its cone
//   all around   one perspective camera when the casters, or the receivers, lie to one side of it; else six square ones, a
//                little wider than 90 degrees, so that a filter's kernel never leaves its own map and no seam shows
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>

#include "techniques/shadow_map/fit/light_maps.h"
#include "techniques/shadow_map/params.h"

namespace shadowlab::shadow_map {

/// The eye that the maps are fitted for.
struct FitEye {
    scene::Camera camera;              ///< its near plane is where the nearest thing in view may be
    double aspect = 1;                 ///< width over height
    std::optional<dvec2> visibleDepth; ///< metres along its axis: of the nearest and farthest visible point, if known
};

struct FitRequest {
    const scene::Light& light;
    std::span<const scene::Bounds> all;       ///< of all objects
    std::span<const scene::Bounds> casters;   ///< of those whose shadow can fall on something
    std::span<const scene::Bounds> receivers; ///< what of them is in view; empty: `all`
    FitEye eye;
    const ProjectionParams& params;
    int resolution = 0;
    int guardTexels = 0; ///< on each side, for the filter's kernel
    double lightReach =
        0; ///< for a penumbra: metres from the light's middle to its border, of a directional light at 1 m
    double widestShare = 0;      ///< of a map's side: no more than that is kept free for a penumbra
    bool castersInDepth = false; ///< nothing is clamped to the near plane: the filter asks how far casters are
    /// What a map holds sideways. shown: casters and receivers together, for a picture of the map; needed: what they share.
    enum class Cover { needed, shown } cover = Cover::needed;
};

LightMaps fitLightMaps(const FitRequest& request);

/// Share of what a map is for, as wide as its side, that guard band and rounding need beyond it on each side.
double guardShare(int resolution, int guardTexels);

} // namespace shadowlab::shadow_map
