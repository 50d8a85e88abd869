// SPDX-License-Identifier: MIT
#include "techniques/registry.h"

#include "techniques/foundation/error.h"
#include "techniques/foundation/nearest_names.h"

namespace shadowlab {

const TechniqueInfo& findTechnique(std::string_view id) {
    std::vector<std::string> known;
    for (const RegisteredTechnique& technique : registeredTechniques()) {
        if (technique.info->id == id) return *technique.info;
        known.emplace_back(technique.info->id);
    }
    throw Error(ExitStatus::usage, "no technique is called '" + std::string(id) + "'; " + suggestion(id, known));
}

} // namespace shadowlab
