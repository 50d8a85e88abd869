// The pictures of a page. Many points draw the same one: each is written once and used wherever it is shown.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::report {

class Pictures {
public:
    /// Markup that shows the picture. `alt`: what it shows, in words. What is no PNG file is told to be missing.
    std::string shown(const std::vector<std::uint8_t>& png, const std::string& alt);

    /// All that were shown, to be put anywhere in the page.
    [[nodiscard]] std::string definitions() const;

private:
    std::map<std::vector<std::uint8_t>, std::size_t> numbers_;
    std::string definitions_;
};

} // namespace shadowlab::report
