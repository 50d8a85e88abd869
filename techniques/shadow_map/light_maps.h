// The light's cameras: which way they look, how wide and how deep, for every kind of light. Knows no graphics API.
//
// A directional light needs one parallel projection, a spot one perspective, a light that shines all around six square
// ones, one per axis. The six are a little wider than 90 degrees, so that a filter's kernel never leaves its own map and no
// seam shows. Everything is relative to the light (world axes, origin at the light), so that nothing is lost far from the
// world's origin. Williams, "Casting Curved Shadows on Curved Surfaces", 1978.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/foundation/scene/scene.h"

namespace shadowlab::shadow_map {

struct LightMaps {
    dvec3 originWorld{0.0};                         ///< of the light-relative space
    std::vector<dmat4> lightViewFromLightRelative;  ///< per layer: the light's camera looks down -z
    std::vector<dmat4> lightClipFromLightView;      ///< per layer
    double nearest = 0, farthest = 1;               ///< of the casters along the camera's axis: the projection's range
    double sceneNearest = 0, sceneFarthest = 1;     ///< of everything there is to see: for false colours
    bool parallel = false;
    [[nodiscard]] int layers() const { return static_cast<int>(lightClipFromLightView.size()); }
    [[nodiscard]] dmat4 lightClipFromLightRelative(int layer) const {
        return lightClipFromLightView[static_cast<std::size_t>(layer)] * lightViewFromLightRelative[static_cast<std::size_t>(layer)];
    }
};

/// Fits the maps to the casters (indices into the scene's objects). `guardTexels` of a map of `resolution` texels lie
/// outside what a receiver looks up, for the filter's kernel.
LightMaps fitLightMaps(const scene::Scene& scene, const scene::Light& light, std::span<const std::size_t> casters,
                       int resolution, int guardTexels);

/// World to light-relative for one object's mesh, composed in double.
dmat4 lightRelativeFromMesh(const LightMaps& maps, const scene::Object& object);

} // namespace shadowlab::shadow_map
