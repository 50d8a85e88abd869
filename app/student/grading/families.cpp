// SPDX-License-Identifier: MIT
#include "app/student/grading/families.h"

#include <array>
#include <string>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"

namespace shadowlab::student {

std::span<const Family> families() {
    static const std::array<Family, 3> all = {{{"planar", "Planar projected shadows", planarCases()},
                                               {"shadow-map", "Shadow map", shadowMapCases()},
                                               {"shadow-volume", "Shadow volume", shadowVolumeCases()}}};
    return all;
}

const Family& findFamily(std::string_view id) {
    std::vector<std::string> known;
    for (const Family& family : families()) {
        if (family.id == id) return family;
        known.emplace_back(family.id);
    }
    throw Error(ExitStatus::usage, "there is no family '" + std::string(id) + "' to grade; " + suggestion(id, known));
}

} // namespace shadowlab::student
