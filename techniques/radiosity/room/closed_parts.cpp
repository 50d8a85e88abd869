// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/closed_parts.h"

#include <algorithm>

namespace shadowlab::radiosity {

namespace {

// Less than this share of the smaller patch's light is no way for light: a few of the lines that were tried between two patches have
// slipped through a wall's very edge. The rays that look for the surroundings are 256, and would miss as much.
constexpr double kLink = 1e-3;

} // namespace

std::vector<std::vector<std::size_t>> closedParts(const ExchangeMatrix& exchange, std::span<const double> areas,
                                                  std::span<const double> surroundings) {
    std::vector<std::vector<std::size_t>> closed;
    std::vector<bool> isKnown(exchange.size(), false);
    for (std::size_t first = 0; first < exchange.size(); ++first) {
        if (isKnown[first]) continue;
        std::vector<std::size_t> part{first};
        isKnown[first] = true;
        for (std::size_t next = 0; next < part.size(); ++next) { // grows while it is gone through
            const std::size_t from = part[next];
            const std::span<const double> row = exchange.row(from);
            for (std::size_t to = 0; to < row.size(); ++to) {
                if (isKnown[to] || !(row[to] > kLink * std::min(areas[from], areas[to]))) continue;
                isKnown[to] = true;
                part.push_back(to);
            }
        }
        if (part.size() == 1) continue; // it sees no patch, and is no room
        if (std::ranges::any_of(part, [&](std::size_t i) { return surroundings[i] != 0; })) continue;
        std::ranges::sort(part);
        closed.push_back(std::move(part));
    }
    return closed;
}

} // namespace shadowlab::radiosity
