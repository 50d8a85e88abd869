// Triangles where they stand in the world, and how far rounding may have moved them: what decides whether two faces coincide.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

struct PlacedTriangle {
    std::array<dvec3, 3> cornersWorld;
    dvec3 rounding{0.0};       ///< of a corner along each axis, metres: by the mesh's floats, and by the matrix in double
    dvec3 doubleRounding{0.0}; ///< the latter alone
    Bounds box;                ///< around the corners and their rounding
    dvec3 normal{0.0};         ///< on the side that sees the corners counter-clockwise, with twice the area as length
};

/// Makes them of one object.
class TrianglePlacer {
public:
    explicit TrianglePlacer(const Object& object);
    [[nodiscard]] PlacedTriangle operator()(std::uint32_t triangle) const;
    /// No corner is rounded more.
    [[nodiscard]] dvec3 mostRounding() const;

private:
    struct Rounding {
        dvec3 all, ofDouble;
    };
    [[nodiscard]] Rounding roundingOf(const dvec3& positionMesh, const dvec3& positionWorld) const;
    const Mesh& mesh_;
    dmat4 worldFromMesh_;
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
