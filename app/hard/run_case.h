// Runs the checks of one hard case: each technique as it should be, and its careless version, which must be found out.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/hard/case.h"
#include "app/measure/verdict.h"

namespace shadowlab::hard {

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
    measure::Counts counts; ///< of the right version
    Outcome outcome = Outcome::right;
    std::optional<bool> caught; ///< is the careless version red? None: the check has none
    double ms = 0;              ///< of the right version's frame
    [[nodiscard]] bool isGreen() const { return outcome == Outcome::right && caught.value_or(true); }
};

/// A row for each check of the case, at its small size or at its own. Needs a current GL context. Throws Error (badInput) where
/// a quantity cannot be had of a technique.
std::vector<Row> runCase(const Case& one, bool small);

} // namespace shadowlab::hard
