// All techniques, in didactic order. The list is generated at build time from the folders beside this file.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string_view>

#include "techniques/technique.h"

namespace shadowlab {

struct RegisteredTechnique {
    std::string_view folder; ///< under techniques/ and shaders/
    const TechniqueInfo* info;
};

std::span<const RegisteredTechnique> registeredTechniques();

/// The technique of that id. Throws Error (usage) naming the nearest ids.
const TechniqueInfo& findTechnique(std::string_view id);

} // namespace shadowlab
