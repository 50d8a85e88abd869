// SPDX-License-Identifier: MIT
#include "app/student/grading/families.h"

#include <array>
#include <sstream>
#include <string>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"

namespace shadowlab::student {

std::span<const Family> families() {
    // Two levels: either picture is rounded to 8 bits, and float arithmetic rounds on the way there. Six levels, some 5 % of a grey's
    // intensity: other points of the same patches change a form factor by as much.
    static const std::array<Family, 5> all = {
        {{"planar", "Planar projected shadows", planarCases()},
         {"shadow-map", "Shadow map", shadowMapCases()},
         {"shadow-volume", "Shadow volume", shadowVolumeCases()},
         {"ray-tracing", "Ray tracing", rayTracingCases(), "lecture-ray-tracing", 2},
         {"radiosity", "Radiosity", radiosityCases(), "lecture-radiosity", 6}}};
    return all;
}

std::vector<int> numbersIn(std::string_view text) {
    std::vector<int> numbers;
    std::istringstream words{std::string(text)};
    for (int number = 0; words >> number;)
        numbers.push_back(number);
    return numbers;
}

std::string_view toText(Judged judged) {
    switch (judged) {
    case Judged::picture: return "picture";
    case Judged::treeDepth: return "tree-depth";
    case Judged::visibility: break;
    }
    return "visibility";
}

std::string familyNames() {
    std::string text;
    for (const Family& family : families())
        text += (text.empty() ? "" : &family == &families().back() ? " or " : ", ") + std::string(family.id);
    return text;
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
