// Memory limits: every patch exchanges light with every other, so memory grows with the square of their number. It is checked
// before it is allocated.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/scene.h"
#include "techniques/radiosity/solvers/solvers.h"

namespace shadowlab::radiosity {

// Each a tenth above the largest measured value (peak resident memory of scenes of 2,000 to 12,000 patches).
/// The matrix of a number of 8 bytes, what it is found from, and its copies: 25.
constexpr std::uint64_t kBytesPerPair = 28;
constexpr std::uint64_t kBytesPerPairDirect = 52; ///< with the direct solver's factors: 47

/// Bytes per triangle of a scene while meshes are simplified, besides what every technique needs; measured: 950 (peak resident
/// memory of balls of a million triangles).
constexpr std::uint64_t kBytesPerTriangleSimplified = 1050;

/// Throws Error (overLimit) where the scene has too many triangles to be simplified within its memory limit.
void requireMemoryToSimplify(const scene::Scene& scene);

/// Throws Error (overLimit) where so many patches, with the scene itself, exceed its memory limit.
void requireMemory(const scene::Scene& scene, std::size_t patches, std::uint64_t bytesPerPair = kBytesPerPair);
std::uint64_t bytesPerPair(SolverKind solver);

} // namespace shadowlab::radiosity
