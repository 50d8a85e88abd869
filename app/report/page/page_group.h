// The parts of a page: the pictures that it shows, and the section about one scene under one light.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "app/report/results.h"
#include "techniques/foundation/math/types.h"

namespace shadowlab::report {

class Pictures {
public:
    /// Markup that shows the picture. `alt`: what it shows, in words. A note in its place where the bytes are no PNG file.
    std::string shown(const std::vector<std::uint8_t>& png, const std::string& alt);

    /// All that were shown, to be put anywhere in the page.
    [[nodiscard]] std::string definitions() const;

private:
    std::map<std::vector<std::uint8_t>, std::size_t> numbers_;
    std::string definitions_;
};

/// The address of a group, and of a point in it, within the page.
std::string groupId(std::size_t group);
std::string pointId(std::size_t group, std::size_t point);

/// Heading, chart, table of points with what lies behind each, and how its sweeps grow.
std::string groupSection(const Report& report, std::size_t group, Pictures& pictures);

} // namespace shadowlab::report
