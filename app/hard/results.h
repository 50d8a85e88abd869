// The result of the hard cases: of each check, and of each technique that was drawn before a case's scene.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/judge/verdict.h"

namespace shadowlab::hard {

/// What a technique draws, and where that is wrong (report::errorMap). `name` is that of the files, without ending; the bytes
/// are empty in what was read back from a part of a report.
struct Pictures {
    std::string name;
    std::vector<std::uint8_t> picturePng, errorPng;
};

/// One expectation of a check, measured.
struct Measured {
    std::string quantity, unit, bound;
    double value = 0;
    std::optional<double> naive; ///< the same of the careless version
    bool holds = false;
    bool naiveHolds = true; ///< without a careless version there is none to be found out
};

enum class Outcome {
    right,
    wrong,
    provesNothing, ///< too little is lit or in shadow
};
std::string_view toText(Outcome outcome);

/// One check, run.
struct Row {
    std::string caseId, title, technique;
    std::vector<std::string> settings, naiveSettings;
    std::vector<Measured> measured;
    judge::Counts counts; ///< of the right version
    Outcome outcome = Outcome::right;
    std::optional<bool> caught; ///< is the careless version red? None: the check has none
    double ms = 0;              ///< of the right version's frame
    Pictures right;
    std::optional<Pictures> naive;
    [[nodiscard]] bool isGreen() const { return outcome == Outcome::right && caught.value_or(true); }
};

/// How a technique did on the scene of a case that states no expectation for it.
enum class Standing {
    exact,         ///< no pixel is wrong
    edges,         ///< pixels are wrong, but only as aliasing makes them
    wrong,         ///< core errors
    provesNothing, ///< too little is lit or in shadow
    refused,       ///< the technique does not draw this scene
};
std::string_view toText(Standing standing);

/// One technique before one case's scene.
struct Cell {
    std::string column;   ///< Column::title()
    bool isExact = false; ///< Column::isExact
    Standing standing = Standing::exact;
    judge::Counts counts;
    int coreErrors = 0;
    double served = 1;  ///< share of the pixels with a surface that the technique serves at all
    double ms = 0;      ///< of a frame in which the light has moved
    std::string reason; ///< why it is wrong, as the case's file says; or why it was refused
    Pictures pictures;
    [[nodiscard]] int wrong() const { return counts.wrong() + counts.stray; }
    /// What is exact by its nature may be wrong only where the case says why.
    [[nodiscard]] bool isGreen() const { return !isExact || standing != Standing::wrong || !reason.empty(); }
};

/// One case and the result; of a case without a scene there are neither rows nor cells.
struct CaseResult {
    std::string id, title, why;
    std::vector<Row> rows;
    std::vector<Cell> cells;
    std::vector<std::string> tests;      ///< that hold it, too
    std::vector<std::string> naiveTests; ///< in which a careless version that is no setting fails
    std::string withoutNaive;            ///< why there is no careless version
    [[nodiscard]] int red() const;
};

} // namespace shadowlab::hard
