// A scene in which heavy meshes are coarser: what light is carried between.
//
// A curved mesh of tens of thousands of triangles would make as many patches, though the light on it changes slowly. So light is
// carried between coarser meshes, and the picture still draws the original ones, each corner with what arrives at its place on the
// coarse mesh. That is an approximation: creases and shadows finer than a cell are lost, and of the surface some share.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/simplify/surface_places.h"

namespace shadowlab::radiosity {

struct SimplifiedScene {
    /// The same objects in the same order with the same materials and matrices. Surfaces of lights have no triangles: they take no part.
    scene::Snapshot scene;
    /// Of each object and each of its original triangles, its corners' places on the simplified scene; nothing for objects that
    /// are as they were.
    std::vector<std::vector<std::array<SurfacePlace, 3>>> cornersOfObject;
    double cellMetres = 0;                                 ///< side of the cells; 0: all is as it was
    std::uint64_t trianglesBefore = 0, trianglesAfter = 0; ///< without those of lights
};

/// At most that many triangles, or as near to that as it gets. Meshes of a hundred triangles and fewer stay as they are, and those of
/// which more than three fourths would remain; of every other at least eight triangles remain, by finer cells of its own if need be.
/// Cells are as small as the number allows, from a series of fourths of a halving that begins with the scene's size.
SimplifiedScene simplifiedScene(const scene::Scene& scene, std::size_t mostFaces);

} // namespace shadowlab::radiosity
