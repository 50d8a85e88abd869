// Finds the patch at any point of the drawn scene: for every triangle a path from a point on it to the patch, and to the patch's
// corners.
//
// Every triangle has coordinates (u, v) in metres in its own plane. The triangles of an object that lie in one plane share them,
// and a binary space partition (patch_tree.h) finds the patch. In a simplified mesh, large original triangles that lie in a plane
// of the simplified mesh are found in the same way; the others are cells of their own, whose corners have the values of their
// places on the simplified mesh.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "techniques/radiosity/interpolation/patch_corners.h"
#include "techniques/radiosity/interpolation/patch_tree.h"
#include "techniques/radiosity/room/room.h"

namespace shadowlab::radiosity {

/// A large original triangle lies in a plane of the simplified mesh if no corner is farther from it than this share of a cell:
/// the rounding of a table's edges moves the corners of its top a little.
constexpr double kOffPlane = 0.02;

/// Tables, as the shader reads them (shaders/radiosity/cell.glsl).
struct SurfaceCells {
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    std::vector<vec4> places; ///< two per triangle: their products with (positionMesh, 1) are u and v
    /// For each triangle: where the search starts for its front and its back; kNone: no patch.
    std::vector<uvec4> roots;
    std::vector<vec4> lines;     ///< for each node of the tree: in front where x u + y v + z > 0
    std::vector<uvec4> branches; ///< for each node: the next node in front and behind
    /// Patch; index of its first border; number of corners; patch + 1, or 0 for a blended cell.
    std::vector<uvec4> cells;
    std::vector<vec4> borders; ///< for each cell its centre, then its corners: u, v, number of a value

    // Values are numbered: first the corners of patches, then the centres of patches, then the blends.
    /// A place on a patch: its value is a weighted mean of those of the patch and two of its corners.
    struct Blend {
        std::uint32_t patch = 0;
        std::array<std::uint32_t, 2> corners{};
        dvec3 weights{0.0};
        std::uint32_t vertex = 0; ///< the vertex at this place
    };
    /// Four for each triangle of a simplified mesh: three corners, and one that stands for their mean.
    std::vector<Blend> blends;
    struct Vertex {
        dvec3 positionCentred, normal; ///< unit, on the visible side
        std::uint32_t object;
    };
    std::vector<Vertex> vertices; ///< of simplified meshes, as they are drawn; each side has its own
    PatchCorners corners;
    std::vector<FaceFrame> frames; ///< of each patch
};

SurfaceCells surfaceCells(const scene::Scene& drawn, const Room& room);

/// The patch at a position on a triangle of the drawn scene (counted through all objects), seen from its front or its back;
/// nothing where there is none. The same search as in the shader.
std::optional<std::uint32_t> patchAt(const SurfaceCells& cells, std::uint32_t triangle, bool fromFront,
                                     const vec3& positionMesh);

/// The patch at a point that a ray has found in the drawn scene; nothing: on the surface of a light, or the inside of a closed body.
std::optional<std::uint32_t> patchOf(const trace::SurfacePoint& point, const SurfaceCells& cells, const trace::SceneTracer& tracer);

/// The values of all blends, computed from those of the patches.
std::vector<dvec3> blended(const SurfaceCells& cells, std::span<const dvec3> ofPatches);

/// The values of all cells, as they are uploaded.
struct CellValues {
    std::vector<vec4> ofPatches; ///< for flat display
    std::vector<vec4> ofBorders; ///< for interpolation
};
CellValues cellValues(const SurfaceCells& cells, std::span<const dvec3> ofPatches, std::span<const dvec3> ofBlends);
inline CellValues cellValues(const SurfaceCells& cells, std::span<const dvec3> ofPatches) {
    return cellValues(cells, ofPatches, blended(cells, ofPatches));
}

} // namespace shadowlab::radiosity
