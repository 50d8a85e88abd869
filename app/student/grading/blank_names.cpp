// SPDX-License-Identifier: MIT
#include "app/student/grading/blank_names.h"

#include <algorithm>
#include <utility>

#include "app/context/assets.h"
#include "app/student/skeletons.h"

namespace shadowlab::student {

std::vector<Blank> blanksOf(const Family& family, const std::string& skeleton) {
    const std::vector<std::string> names = skeletonNames();
    if (skeleton == "empty" || std::ranges::find(names, skeleton) == names.end()) return {};
    Skeleton known = readSkeleton(context::assetsRoot() / "skeletons" / (skeleton + ".json"));
    return known.family == family.id ? std::move(known.blanks) : std::vector<Blank>();
}

std::string namesOf(const std::vector<int>& numbers, const std::vector<Blank>& blanks) {
    constexpr std::size_t kMost = 3; // of four or more none is meant
    if (blanks.empty() || numbers.size() > kMost) return "";
    std::string names;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const bool isLast = i + 1 == numbers.size();
        names += (i == 0 ? "" : isLast ? ", or " : ", ") + std::string("blank ") + std::to_string(numbers[i]) + " (" +
                 blanks.at(static_cast<std::size_t>(numbers[i]) - 1).idea + ")";
    }
    return names;
}

} // namespace shadowlab::student
