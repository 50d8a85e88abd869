// Triangles where they stand in the world, and how far rounding may have moved them: what decides whether two faces coincide.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

struct PlacedTriangle {
    std::array<dvec3, 3> cornersWorld;
    double rounding = 0;       ///< of a corner along each axis, metres: of the file's numbers and the mesh's floats, and by the matrix
    double doubleRounding = 0; ///< by the matrix alone
    Bounds box;                ///< around the corners and their rounding
    dvec3 normal{0.0};         ///< on the side that sees the corners counter-clockwise, with twice the area as length
};

/// Makes them of one object.
class TrianglePlacer {
public:
    explicit TrianglePlacer(const Object& object);
    [[nodiscard]] PlacedTriangle operator()(std::uint32_t triangle) const;
    /// Of all its triangles.
    [[nodiscard]] double rounding() const { return rounding_; }

private:
    const Mesh& mesh_;
    dmat4 worldFromMesh_;
    double rounding_ = 0, doubleRounding_ = 0;
};

/// Do they lie in one plane, but for rounding, and share more of it than an edge?
bool coincide(const PlacedTriangle& a, const PlacedTriangle& b);

/// Of two that do: how far apart rounding of float has put their planes, metres. Then they cross each other anywhere. 0: rounding of
/// double explains it.
double gapBetween(const PlacedTriangle& a, const PlacedTriangle& b);

/// The direction of the normal for a quick look: nought where rounding may have turned it by more than kTurned radians.
vec3 roughNormal(const PlacedTriangle& triangle);
constexpr double kTurned = 1e-3;

/// Can the planes of two with these rough normals be one?
inline bool mayBeParallel(const vec3& a, const vec3& b) {
    constexpr auto kMostTurned = static_cast<float>(4 * kTurned); // both, and as much again for float
    const vec3 across = glm::cross(a, b);
    return glm::dot(across, across) <= kMostTurned * kMostTurned;
}

/// The axis along which a plane with this normal is seen largest.
int mainAxis(const dvec3& normal);

} // namespace shadowlab::scene
