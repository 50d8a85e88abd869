// Runs one hard case: its checks, each technique as it should be and its careless version, which must be detected; and every
// technique on its scene, whatever the result.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "app/hard/case.h"
#include "app/hard/columns.h"
#include "app/hard/results.h"

namespace shadowlab::hard {

/// A row for each check of the case, at its small size or at its own. Needs a current GL context. Throws Error (badInput) where
/// a technique does not provide a quantity.
std::vector<Row> runCase(const Case& one, bool small);

/// The same with a cell for each column, where the case has a scene.
CaseResult runWholeCase(const Case& one, bool small, std::span<const Column> columns);

} // namespace shadowlab::hard
