// What the page of a report looks like, and what it does when a script may run.
// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>

namespace shadowlab::report {

extern const std::string_view kPageStyle, kPageScript, kCardsScript;

} // namespace shadowlab::report
