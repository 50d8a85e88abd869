// A hard case: a scene made to break careless shadows, what each technique has to make of it, and the careless versions that
// must be detected. What its file says (docs/hard-cases.md), checked and made complete.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/course/lessons/lesson.h"
#include "app/course/shown_state.h"

namespace shadowlab::hard {

/// A number that is measured of a check, and what it has to be.
struct Expectation {
    std::string quantity; ///< quantities.h
    course::Bound bound;
    std::optional<course::ShownState> from; ///< of a comparison: the other picture
};

/// One technique with its settings before one scene; and a careless version of it, which must not pass.
struct Check {
    std::string title;
    course::ShownState right; ///< one slot
    std::vector<std::string> settings;
    std::optional<course::ShownState> naive;
    std::vector<std::string> naiveSettings;
    std::vector<Expectation> expectations;
};

/// Why a technique is wrong before the case's scene, where that is known and has its reason.
struct Limit {
    lab::PaneState slot;
    std::string why;
};

/// Without so many pixels, nothing is proved.
struct Least {
    int lit = 0, shadowed = 0;
};

struct Case {
    std::string id;             ///< "P2b"
    std::string name;           ///< of the file, without folder and ending
    std::filesystem::path file; ///< for messages
    std::string title;
    std::string why;                            ///< what the careless version does, and why the right one holds
    std::optional<course::ShownState> picture; ///< the case's own scene; none: it is about numbers alone
    ivec2 size{0}, smallSize{0};
    Least least;
    std::vector<Check> checks;
    std::vector<std::string> tests;      ///< that hold the case, SUITE.NAME
    std::vector<std::string> naiveTests; ///< in which a careless version that is no setting fails
    std::string withoutNaive;            ///< why there is no careless version; empty: there is one
    std::vector<Limit> limits;
};

/// Where in the list of cases one stands: family P, M, V, R, F, then number, then letter.
bool isBefore(const std::string& id, const std::string& otherId);

/// One case. Throws Error (badInput, overLimit) with FILE:LINE:COLUMN for what a case may not say, and all that loading
/// its scenes throws.
Case loadCase(const std::filesystem::path& file, const scene::LoadOptions& options);

/// The same from a text; `file` is named in errors, and scenes are looked for beside it.
Case parseCase(const std::string& text, const std::filesystem::path& file, const scene::LoadOptions& options);

/// The files of the cases in assets/hard, by their names.
std::vector<std::filesystem::path> caseFiles(const std::filesystem::path& assetsRoot);

/// All cases of assets/hard, in the order of isBefore().
std::vector<Case> allCases(const scene::LoadOptions& options);

} // namespace shadowlab::hard
