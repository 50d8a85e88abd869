// Flattening onto a plane: the one matrix of projected shadows, and where it may be used.
//
// A point v between the light l and the plane p casts its shadow where the line from l through v meets the plane:
//
//     v' = (p.l) v - (p.v) l            Blinn, "Me and My (Fake) Shadow", 1988
//
// linear in v, so a matrix; p = (N, D) and v, l are homogeneous (l.w = 0: a directional light). Divided by p.l its weight is
//
//     v'.w = 1 - l.w (p.v) / (p.l)
//
// 1 on the plane, 0 at the light's height, negative beyond. There the line meets the plane on the far side of the light,
// and the image would be a false shadow (an anti-shadow). Points below the plane (p.v < 0) cast no shadow on it either.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>

#include "techniques/foundation/gl/scene/surfaces.h"
#include "techniques/planar/receivers/flat_faces.h"

namespace shadowlab::planar {

/// All in view space, in double: relative to the eye nothing is lost far from the world's origin.
struct Projection {
    dvec4 planeView{0.0};   ///< (N, D), N unit, positive on the light's side
    dvec4 lightView{0.0};   ///< homogeneous
    double lightHeight = 0; ///< p.l: of the light above the plane; toward a directional light the cosine
    dmat4 flattenedFromView{1.0};

    /// How high a point is above the plane, as a row to be multiplied with the point in mesh space.
    [[nodiscard]] dvec4 heightRow(const dmat4& viewFromMesh) const { return planeView * viewFromMesh; }
    /// The weight v'.w, as such a row.
    [[nodiscard]] dvec4 weightRow(const dmat4& viewFromMesh) const;
};

/// (N, D) of a flat face in a space that is reached from mesh space by a matrix.
dvec4 planeOf(const FlatFace& face, const dmat4& spaceFromMesh);

/// The distance of a light from the farthest corner of a frame; of a direction, whose height is that of a unit vector, 1.
double reachOf(const dvec4& lightView, const std::array<dvec3, 4>& frameView);

/// Nothing if the light lies in the plane, or so low for its reach that it only grazes it.
std::optional<Projection> projectOnto(const dvec4& planeView, const dvec4& lightView, double reach = 0);

/// Geometry below this height counts as part of the plane: its own triangles, and what lies on it. In metres: the
/// unevenness of the face plus the rounding of heights. `farthestMesh`: largest absolute coordinates of what is flattened.
double contactHeight(const Projection& projection, const gl::EyeMatrices& eye, const dmat4& viewFromMesh,
                     const dvec3& farthestMesh, double unevenness);

/// True if something in the box, higher than `contact`, may cast a visible shadow within the frame of the face.
/// Conservative.
bool mayShadow(const scene::Bounds& box, const gl::EyeMatrices& eye, const Projection& projection, double contact,
               const std::array<dvec3, 4>& frameView);

} // namespace shadowlab::planar
