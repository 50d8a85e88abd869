// Where on the scene's surfaces is which patch? For pictures: triangles of the scene as it is drawn, each with a way from a
// point on it to the patch, and to the patch's corners.
//
// Every triangle has coordinates (u, v) in metres in its own plane. Those of an object that lie in one plane share them, and a tree
// of lines (patch_tree.h) finds the patch. Of a mesh that was simplified, large triangles that lie in a plane of the simplified mesh are
// found in the same way; the others are cells of their own, whose corners have the values of their places on the simplified mesh.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "techniques/radiosity/interpolation/patch_corners.h"
#include "techniques/radiosity/interpolation/patch_tree.h"
#include "techniques/radiosity/room/room.h"

namespace shadowlab::radiosity {

/// Coordinates in the plane of a face.
struct FaceFrame {
    dvec3 originCentred{0.0}, u{0.0}, v{0.0}; ///< u and v are unit
    [[nodiscard]] dvec2 place(const dvec3& pointCentred) const {
        return {glm::dot(u, pointCentred - originCentred), glm::dot(v, pointCentred - originCentred)};
    }
};
/// u lies along its first edge. Seen from the front of the triangle, u and v are right-handed.
FaceFrame frameOf(const Polygon& polygon);

/// A large triangle of a mesh that was simplified lies in a plane of the simplified mesh if it is nowhere farther off than this
/// share of a cell: the rounding of a table's edges takes the corners of its top a little off.
constexpr double kOffPlane = 0.02;

/// As a shader reads them (shaders/radiosity/cell.glsl).
struct SurfaceCells {
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    std::vector<vec4> places; ///< two for each triangle: products with (positionMesh, 1) are u and v
    std::vector<uvec4>
        roots;               ///< of each triangle: where to begin for its front and for its back; kNone: no patch there
    std::vector<vec4> lines; ///< of each node of the tree: in front where x u + y v + z > 0
    std::vector<uvec4> branches; ///< of each node: what comes next in front and behind
    std::vector<uvec4>
        cells; ///< patch; first of its borders; how many corners follow; patch + 1, or 0 if it is none of its own
    std::vector<vec4> borders; ///< of each cell its centre, then its corners: u, v, number of a value

    // What the numbers of values mean: first corners of patches, then centres of patches, then these.
    /// A place on a patch: its value is that of the patch and of two of its corners, mixed.
    struct Blend {
        std::uint32_t patch = 0;
        std::array<std::uint32_t, 2> corners{};
        dvec3 weights{0.0};
        std::uint32_t vertex = 0; ///< what has this place
    };
    /// Three for each triangle of a mesh that was simplified, and one in whose place the mean of the three stands.
    std::vector<Blend> blends;
    struct Vertex {
        dvec3 positionCentred, normal; ///< unit, on the side that is seen
        std::uint32_t object;
    };
    std::vector<Vertex> vertices; ///< of meshes that were simplified, as they are drawn; of each side its own
    PatchCorners corners;
    std::vector<FaceFrame> frames; ///< of each patch
};

SurfaceCells surfaceCells(const scene::Scene& drawn, const Room& room);

/// The patch at a position on a triangle of the scene that is drawn, counted through all objects, seen from its front or its back;
/// nothing where there is none. As shaders find it.
std::optional<std::uint32_t> patchAt(const SurfaceCells& cells, std::uint32_t triangle, bool fromFront,
                                     const vec3& positionMesh);

/// The values of all blends, from those of the patches.
std::vector<dvec3> blended(const SurfaceCells& cells, std::span<const dvec3> ofPatches);

/// The values of all cells.
struct CellValues {
    std::vector<vec4> ofPatches; ///< for flat display
    std::vector<vec4> ofBorders; ///< for interpolation
};
CellValues cellValues(const SurfaceCells& cells, std::span<const dvec3> ofPatches, std::span<const dvec3> ofBlends);
inline CellValues cellValues(const SurfaceCells& cells, std::span<const dvec3> ofPatches) {
    return cellValues(cells, ofPatches, blended(cells, ofPatches));
}

} // namespace shadowlab::radiosity
