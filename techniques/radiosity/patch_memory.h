// Every patch exchanges light with every other: memory grows with the square of their number, and is judged before it is taken.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/scene.h"
#include "techniques/radiosity/solvers.h"

namespace shadowlab::radiosity {

// Each a tenth above the largest that was measured (peak resident memory of scenes of 2,000 to 12,000 patches).
constexpr std::uint64_t kBytesPerPair =
    28; ///< the matrix of a number of 8 bytes, what it is found from, and its copies: 25
constexpr std::uint64_t kBytesPerPairDirect = 52; ///< with the direct solver's factors: 47

/// Throws Error (overLimit) where so many patches, with the scene itself, need more than its limit of memory.
void requireMemory(const scene::Scene& scene, std::size_t patches, std::uint64_t bytesPerPair = kBytesPerPair);
std::uint64_t bytesPerPair(SolverKind solver);

} // namespace shadowlab::radiosity
