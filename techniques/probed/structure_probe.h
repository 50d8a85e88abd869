// What a ray passes of the structure that spares it intersection tests.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab {

/// The structure that a ray is traced with: volumes within volumes, or a grid of cells.
struct StructureProbe {
    struct Volume {
        int level = 0, parent = -1; ///< a place in `volumes`, before this one; -1: nothing is around it
        bool isBall = false;
        dvec3 lowerWorld{0.0}, upperWorld{0.0}; ///< of the box around it
        double radius = 0;                      ///< of a ball, whose centre is the box's
        std::string object{};                   ///< of which it holds all, and nothing else
        bool isEntered = false;                 ///< by the eye ray, on its way to the first surface
        bool isAsked = false;                   ///< the ray has entered all that is around it
    };
    struct Cell {
        glm::ivec3 at{0}; ///< column, row, layer
        dvec3 lowerWorld{0.0}, upperWorld{0.0};
        std::vector<std::string> objects; ///< that its list names
    };
    std::vector<Volume> volumes; ///< level by level
    // Of a grid.
    dvec3 lowerWorld{0.0}, upperWorld{0.0};
    glm::ivec3 counts{0};    ///< of its cells; 0: it is no grid
    std::vector<Cell> cells; ///< that the eye ray passes on its way to the first surface, in order
};

} // namespace shadowlab
