// What a random scene is made of, in whole numbers: easy to draw by chance, and to shrink.
//
// All places are multiples of 2^-10 metres. Sums and differences of such numbers, and products with powers of two, are exact
// in float and double alike; so what changes in a picture when everything is moved or scaled is no rounding of the scene.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <ostream>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"
#include "tests/relations/solids.h"

namespace shadowlab::relations {

enum class SolidKind { box, ball, prism, hull };

/// A closed mesh, wound outward.
struct SolidRecipe {
    SolidKind kind = SolidKind::box;
    ivec3 place{0};     ///< of its middle: x and z from the middle of the floor, y from standing on it
    ivec3 size{0};      ///< beyond the smallest, full extents
    unsigned shape = 0; ///< of hulls and prisms: which corners
};

enum class LightKind { lamp, sun, spot };

struct LightRecipe {
    LightKind kind = LightKind::lamp;
    ivec3 place{0}; ///< from a place high above the middle; suns and spots shine from there to the middle
};

struct EyeRecipe {
    int aroundDegrees = 0, height = 0, distance = 0;
    ivec3 target{0};
};

struct Recipe {
    std::vector<SolidRecipe> solids;
    std::vector<LightRecipe> lights;
    EyeRecipe eye;
    unsigned chance = 0; ///< for whatever else a relation chooses: an axis, an angle, an order
};
std::ostream& operator<<(std::ostream& stream, const Recipe& recipe);

/// Floor, solids, lights and eye, with diffuse surfaces of three greys.
scene::Scene sceneOf(const Recipe& recipe);

/// Are eye and lights outside of all solids, and the eye and the corners of its near plane out of all shadows? Counting from
/// the eye (z-pass) fails by design where they are not; that has tests of its own.
bool standsFree(const scene::Scene& scene);

/// Writes the scene as NAME.json, its meshes as OBJ files beside it, every vertex at its place in the world; the program
/// opens it. Of an object with several materials the first one is written. Returns the path of the scene file.
std::filesystem::path writeScene(const scene::Scene& scene, const std::filesystem::path& folder,
                                 const std::string& name);

} // namespace shadowlab::relations
