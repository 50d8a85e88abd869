// The part of a page that is about one scene under one light.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/report/page/page_pictures.h"
#include "app/report/results.h"

namespace shadowlab::report {

/// The address of a group, and of a point in it, within the page.
std::string groupId(std::size_t group);
std::string pointId(std::size_t group, std::size_t point);

/// Heading, chart, table of points with what lies behind each, and how its sweeps grow.
std::string groupSection(const Report& report, std::size_t group, Pictures& pictures);

} // namespace shadowlab::report
