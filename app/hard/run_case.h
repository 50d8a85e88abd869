// Runs one hard case: its checks, each technique as it should be and its careless version, which must be found out; and every
// technique before its scene, whatever comes of it.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "app/hard/case.h"
#include "app/hard/columns.h"
#include "app/hard/results.h"

namespace shadowlab::hard {

/// A row for each check of the case, at its small size or at its own. Needs a current GL context. Throws Error (badInput) where
/// a quantity cannot be had of a technique.
std::vector<Row> runCase(const Case& one, bool small);

/// The same with a cell for each column, where the case has a scene.
CaseResult runWholeCase(const Case& one, bool small, std::span<const Column> columns);

} // namespace shadowlab::hard
