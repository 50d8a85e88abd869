// The built-in shapes as meshes. Vertices are computed in double and rounded to float once.
//
// Each has texture coordinates (u, v): u runs to the right of the image, v up. Seen from outside, no image is mirrored.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <string_view>

#include "techniques/foundation/scene/model/mesh.h"

namespace shadowlab::scene {

/// Rectangle in the xz plane, centred on the origin, facing +y. `size` is the full extent along x and z.
/// u along +x, v along -z, each from 0 to 1: upright when the quad is tilted up to face +z.
Mesh makeQuad(dvec2 size);

/// Axis-aligned box centred on the origin, six flat faces looking outward. `size` is the full extent.
/// The whole image on each face: upright on the four sides, with v along -z on top and along +z below.
Mesh makeBox(dvec3 size);

/// Sphere with its poles on y and its vertices on the sphere: `segments` around, half as many from pole to pole.
/// Smooth shading normals. u is the longitude, from 0 at +x by way of -z to 1; v is 0 at the south pole and 1 at the
/// north pole, even in angle.
Mesh makeSphere(double radius, int segments);

/// Torus around the y axis, smooth. `segments` = (around the axis, around the tube).
/// u is the longitude, as on the sphere; v goes from 0 at the outer equator by way of the top to 1.
Mesh makeTorus(double majorRadius, double minorRadius, ivec2 segments);

/// A rect light's surface in world space: one parallelogram facing cross(edgeU, edgeV), centred on the origin.
/// No texture coordinates.
Mesh makeParallelogram(const dvec3& edgeU, const dvec3& edgeV);

enum class NormalMode { file, flat, smooth };
constexpr std::array<std::string_view, 3> kNormalModes{"file", "flat", "smooth"}; ///< as scene files and options name them

/// Rebuilds the vertices so that each triangle has its own flat normal, or each position one area-weighted smooth one.
/// Triangle order and the order of the three corners stay as they are. `file` returns the mesh unchanged.
Mesh withNormals(const Mesh& mesh, NormalMode mode);

} // namespace shadowlab::scene
