// A scene with simplified meshes, between which light is exchanged.
//
// A curved mesh of tens of thousands of triangles would make as many patches, although the light on it changes slowly. So light
// is exchanged between simplified meshes. The picture still draws the original ones, each vertex with the irradiance at its place
// on the simplified mesh. This is an approximation: creases and shadows finer than a cell are lost, and some of the surface area.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "techniques/radiosity/simplify/surface_places.h"

namespace shadowlab::radiosity {

struct SimplifiedScene {
    /// The same objects in the same order, with the same materials and matrices. Surfaces of lights have no triangles: they take
    /// no part.
    scene::Snapshot scene;
    /// For each object and each of its original triangles, the places of its corners on the simplified scene; empty for objects
    /// that are not simplified.
    std::vector<std::vector<std::array<SurfacePlace, 3>>> cornersOfObject;
    struct Areas {
        double before = 0, after = 0; ///< of a part of a mesh, m^2
    };
    /// For each object and each part of its mesh; empty for objects that are not simplified.
    std::vector<std::vector<Areas>> areasOfObject;
    double cellMetres = 0;                                 ///< side of the cells; 0: nothing is simplified
    std::uint64_t trianglesBefore = 0, trianglesAfter = 0; ///< without the surfaces of lights
};

/// At most that many sides of triangles that exchange light, as far as possible. `sidesOfObject`: 1 for bodies whose inside is dark, 2
/// for all others; empty: 1 for all. Meshes of up to a hundred triangles stay as they are, and those of which more than three fourths
/// would remain. Every other mesh keeps at least eight triangles, by finer cells of its own if necessary. Cells are as small as the
/// number allows, among the scene's size times 2^(-k/4), k = 0, 1, 2 ... Where all of these leave too many, each mesh becomes about a box.
SimplifiedScene simplifiedScene(const scene::Scene& scene, std::size_t mostSides, std::span<const std::uint8_t> sidesOfObject = {});

} // namespace shadowlab::radiosity
