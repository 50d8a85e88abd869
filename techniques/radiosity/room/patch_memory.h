// Every patch exchanges light with every other: memory grows with the square of their number, and is judged before it is taken.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/scene.h"
#include "techniques/radiosity/solvers/solvers.h"

namespace shadowlab::radiosity {

// Each a tenth above the largest that was measured (peak resident memory of scenes of 2,000 to 12,000 patches).
constexpr std::uint64_t kBytesPerPair =
    28; ///< the matrix of a number of 8 bytes, what it is found from, and its copies: 25
constexpr std::uint64_t kBytesPerPairDirect = 52; ///< with the direct solver's factors: 47

/// A triangle of a scene, while fewer are found to stand for it, beside what it takes with every technique: 950 (peak resident memory
/// of balls of a million triangles).
constexpr std::uint64_t kBytesPerTriangleSimplified = 1050;

/// Throws Error (overLimit) where so many triangles cannot be simplified within the limit of memory.
void requireMemoryToSimplify(const scene::Scene& scene);

/// Throws Error (overLimit) where so many patches, with the scene itself, need more than its limit of memory.
void requireMemory(const scene::Scene& scene, std::size_t patches, std::uint64_t bytesPerPair = kBytesPerPair);
std::uint64_t bytesPerPair(SolverKind solver);

} // namespace shadowlab::radiosity
