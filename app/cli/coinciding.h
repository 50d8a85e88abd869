// What inspect says of faces that coincide: whose they are, how many, and which is seen (scene/query/coincident/coincident_faces.h).
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::cli {

/// Triangles of one surface that coincide with those of another one, or of itself.
struct Coinciding {
    std::string first, second; ///< an object, and of several materials the one
    bool faceAlike = false;    ///< their fronts are on one side; else they turn their fronts away from each other
    bool stands = false;       ///< a closed body stands on a face of another: an eye outside cannot see where
    std::uint64_t pairs = 0;   ///< of triangles
    std::string seen;          ///< in words
};

/// In the order of the scene.
std::vector<Coinciding> coinciding(const scene::Scene& scene);

} // namespace shadowlab::cli
