// The faces of a shadow volume that a line from the eye crosses: in double, what the rasteriser counts for one pixel.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "techniques/shadow_volume/count/volume_end.h"
#include "techniques/shadow_volume/cull/casters.h"

namespace shadowlab::shadow_volume {

/// The line from the eye: a unit direction.
struct EyeLine {
    dvec3 eyeWorld{0.0}, directionWorld{0, 0, -1};
};

struct CrossedFace {
    enum class Part { side, topCap, topCapReversed, bottomCap } part = Part::side;
    std::size_t triangle = 0; ///< of that list of the Volume
    double distance = 0;      ///< metres along the line; infinite where the face is at infinity
    bool facesEye = false;
    std::array<dvec4, 3> cornersWorld{}; ///< homogeneous: w = 0 at infinity
};

/// Only faces in front of the eye, in drawing order. The vertices are the drawn ones, extruded in double. A line through an
/// edge or a corner is moved aside by an infinitesimal amount, the same for all faces (simulation of simplicity,
/// Edelsbrunner and Mücke 1990): so what enters a volume also leaves it.
std::vector<CrossedFace> crossedFaces(const scene::Scene& scene, const CasterVolume& caster, const VolumeEnd& end,
                                      const scene::Light& light, const EyeLine& line);

/// The silhouette edge that a triangle of Volume::sides belongs to.
const SilhouetteEdge& edgeOfSide(const CasterVolume& caster, std::size_t triangle);

/// The triangle of the mesh that a triangle of a cap is, or at whose vertices' images it is.
std::uint32_t triangleOfCap(const CasterVolume& caster, CrossedFace::Part part, std::size_t triangle);

} // namespace shadowlab::shadow_volume
