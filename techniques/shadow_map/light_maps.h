// The light's cameras: which way they look, how wide and how deep, for every kind of light. Knows no graphics API.
//
// A directional light needs one parallel projection, a spot one perspective. A light that shines all around needs one
// perspective when all casters lie to one side of it, and six square ones, one per axis, when it stands among them. The
// six are a little wider than 90 degrees, so that a filter's kernel never leaves its own map and no seam shows.
// Everything is relative to the light (world axes, origin at the light), so that nothing is lost far from the world's
// origin. Williams, "Casting Curved Shadows on Curved Surfaces", 1978.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/foundation/scene/scene.h"

namespace shadowlab::shadow_map {

struct LightMaps {
    dvec3 originWorld{0.0};                        ///< of the light-relative space
    std::vector<dmat4> lightViewFromLightRelative; ///< per layer: the light's camera looks down -z
    std::vector<dmat4> lightClipFromLightView;     ///< per layer
    double nearest = 0, farthest = 1;              ///< along the camera's axis: the projection's range
    bool parallel = false;
    [[nodiscard]] int layers() const { return static_cast<int>(lightClipFromLightView.size()); }
    [[nodiscard]] dmat4 lightClipFromLightRelative(int layer) const {
        return lightClipFromLightView[static_cast<std::size_t>(layer)] *
               lightViewFromLightRelative[static_cast<std::size_t>(layer)];
    }
};

/// Fits the maps sideways to the casters (indices into the scene's objects) and, when given, to a region of the world; in
/// depth to the whole scene. `guardTexels` of a map of `resolution` texels lie outside what a receiver looks up, for the
/// filter's kernel.
LightMaps fitLightMaps(const scene::Scene& scene, const scene::Light& light, std::span<const std::size_t> casters,
                       int resolution, int guardTexels, const scene::Bounds& region = {});

/// World to light-relative for one object's mesh, composed in double.
dmat4 lightRelativeFromMesh(const LightMaps& maps, const scene::Object& object);

} // namespace shadowlab::shadow_map
