// What is put around a model that comes without a floor, a light or a camera. All lengths are in proportion to its size.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// The model where it stands.
struct Stage {
    Bounds meshWorld;
    double size = 0;       ///< largest extent of the model; every length is a multiple of it
    double floorWorld = 0; ///< height of the floor
};

/// The way that a model with these bounds is moved: centred over the origin, its lowest point on y = 0.
dvec3 ontoStage(const Bounds& bounds);
/// The stage of a model that has been moved; `size` as it was before, since a sum is rounded.
Stage stageAround(const Bounds& meshWorld, double size);
double largestExtent(const Bounds& bounds);

/// The materials 0 to 2 of a staged scene: white, as in every scene; the floor's; clay, for parts without a material of their own.
std::vector<Material> stageMaterials();
constexpr std::uint32_t kFloorMaterial = 1, kClay = 2;

Object floorUnder(const Stage& stage);
Light keyLight(const Stage& stage);
/// From the front right and above, so near that these points of the model and their shadows by that light fill the picture.
Camera stageFraming(const Stage& stage, std::span<const dvec3> pointsWorld, const dvec3& lightPositionWorld);

} // namespace shadowlab::scene
