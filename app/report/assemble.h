// From the parts in a folder to a report: everything that is written at the end follows from them alone.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "app/report/store.h"

namespace shadowlab::report {

/// The points of a plan that none of the folders has yet, as "SCENE@LIGHT POINT".
std::vector<std::string> missingPoints(std::span<const Store> stores, const Plan& plan);

/// What the folder has of its plan, analysed. Groups are split where their points are compared with different truths.
Report assemble(const Store& store);

/// The words that measure a point again, quoted for a shell.
std::string commandFor(const Plan& plan, const PlannedGroup& group, const PointKey& point);

/// All numbers of the report, for other programs.
std::string reportJson(const Report& report);
/// One line for each point.
std::string reportCsv(const Report& report);

/// Writes report.json, points.csv, a chart for each group, and the page.
void writeOutputs(const Store& store, const Report& report);

} // namespace shadowlab::report
