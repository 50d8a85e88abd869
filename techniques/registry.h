// All techniques, in didactic order. The list is generated at build time from the folders beside this file.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "techniques/technique.h"

namespace shadowlab {

struct RegisteredTechnique {
    std::string_view folder; ///< under techniques/ and shaders/
    const TechniqueInfo* info;
};

std::span<const RegisteredTechnique> registeredTechniques();

/// Those of one group, in the same order. What is said of "all techniques" means the production ones.
std::vector<RegisteredTechnique> techniquesOf(TechniqueGroup group);

/// Of a production technique the lecture's version, and of the lecture's the production technique that refines it; null: there is
/// none. A technique that is no lecture version's sister itself shares the last one of its folder.
const TechniqueInfo* sisterOf(const TechniqueInfo& info);

/// The technique of that id. Throws Error (usage) naming the nearest ids.
const TechniqueInfo& findTechnique(std::string_view id);

} // namespace shadowlab
