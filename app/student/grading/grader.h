// Holds a plug-in against what is right in every case of a family: the truth about visibility, or the picture of the lecture's own
// algorithm.
//
// The plug-in draws in another process, a new one for each case, and hands over pictures; what is right is found where nothing of the
// plug-in runs. So it cannot change its marks, and what happens to it happens to it alone.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/judge/verdict.h"
#include "app/student/grading/child_program.h"
#include "app/student/grading/families.h"
#include "techniques/foundation/image/image.h"

namespace shadowlab::student {

/// What is graded: one technique of a plug-in.
struct Candidate {
    std::filesystem::path plugin;
    std::string technique;
    std::string backend = "auto"; ///< what it draws with
};

/// How its processes run.
struct Conditions {
    ChildLimits limits;
    Sandbox sandbox;
};

struct CaseResult {
    const Case* which = nullptr;
    std::optional<int> wrong; ///< pixels; none: it drew no picture
    std::string failure;      ///< why it drew none
    judge::Counts counts;     ///< of visibility: of the truth and, if there is a picture, of what is wrong in it
    image::Image picture;     ///< of a case that is not right: student, what is right, difference
    [[nodiscard]] bool isRight() const { return wrong && *wrong <= which->limit; }
    [[nodiscard]] int points() const { return isRight() ? which->points : 0; }
};

struct Sheet {
    const Family* family = nullptr;
    Candidate candidate;
    std::vector<CaseResult> results;
    [[nodiscard]] int points() const;
    [[nodiscard]] int mostPoints() const;
};

/// What is wrong in a case that is not right, as sentences.
std::string whatIsWrong(const CaseResult& result, const Family& family);

/// Where to look in such a case. Empty without a picture: what crashes, or takes too long, says nothing of the idea that is tested.
std::string hintOf(const CaseResult& result);

/// Asks a plug-in, in a process of its own, which techniques it has, which family it says it is of (empty: none), and which
/// skeleton it was made from (skeletonOf()). Throws Error
/// (badInput) with the line that its loading failed with.
struct Declared {
    std::vector<std::string> techniques;
    std::string family, skeleton;
};
Declared askPlugin(const std::filesystem::path& plugin, const Conditions& conditions);

/// Needs a current GL context, for the ties of the truth. `done` is told how many cases are through.
Sheet grade(const Candidate& candidate, const Family& family, const Conditions& conditions,
            const std::function<void(int)>& done);

} // namespace shadowlab::student
