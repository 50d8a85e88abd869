// SPDX-License-Identifier: MIT
#include "techniques/added_techniques.h"

#include <algorithm>
#include <iterator>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"

namespace shadowlab {

namespace {

std::vector<RegisteredTechnique>& all() {
    static std::vector<RegisteredTechnique> list = builtInTechniques();
    return list;
}

} // namespace

std::span<const RegisteredTechnique> registeredTechniques() { return all(); }

std::vector<RegisteredTechnique> techniquesOf(TechniqueGroup group) {
    std::vector<RegisteredTechnique> some;
    std::ranges::copy_if(all(), std::back_inserter(some),
                         [&](const RegisteredTechnique& technique) { return technique.info->group == group; });
    return some;
}

std::string_view toText(TechniqueGroup group) { return group == TechniqueGroup::lecture ? "lecture" : "production"; }

const TechniqueInfo* sisterOf(const TechniqueInfo& info) {
    if (info.group == TechniqueGroup::lecture) return &findTechnique(info.sister);
    const auto folderOf = [](const TechniqueInfo& of) { return std::ranges::find(all(), &of, &RegisteredTechnique::info)->folder; };
    const TechniqueInfo* ofFolder = nullptr;
    for (const RegisteredTechnique& technique : techniquesOf(TechniqueGroup::lecture)) {
        if (technique.info->sister == info.id) return technique.info;
        if (folderOf(findTechnique(technique.info->sister)) == folderOf(info)) ofFolder = technique.info;
    }
    return ofFolder;
}

void addTechniques(std::string_view folder, std::span<const TechniqueInfo> infos) {
    for (const TechniqueInfo& info : infos)
        all().push_back({folder, &info});
}

const TechniqueInfo& findTechnique(std::string_view id) {
    std::vector<std::string> known;
    for (const RegisteredTechnique& technique : registeredTechniques()) {
        if (technique.info->id == id) return *technique.info;
        known.emplace_back(technique.info->id);
    }
    throw Error(ExitStatus::usage, "no technique is called '" + std::string(id) + "'; " + suggestion(id, known) +
                                       " (one of a plug-in: add --plugin FILE)");
}

} // namespace shadowlab
