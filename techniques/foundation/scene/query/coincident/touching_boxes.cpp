// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/coincident/touching_boxes.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace shadowlab::scene {

namespace {

struct Cell {
    int level;               ///< its side is two to this power
    std::int64_t x, y, z;    ///< in sides, from the origin
    bool operator==(const Cell&) const = default;
};

struct CellHash {
    std::size_t operator()(const Cell& cell) const {
        // Mixed by odd constants whose bits are spread evenly (multiples of the golden ratio).
        std::uint64_t hash = static_cast<std::uint64_t>(cell.level);
        for (const std::int64_t place : {cell.x, cell.y, cell.z})
            hash = (hash ^ static_cast<std::uint64_t>(place)) * 0x9e3779b97f4a7c15u ^ (hash >> 29);
        return hash;
    }
};

std::int64_t cellOf(double position, int level) { return static_cast<std::int64_t>(std::floor(std::ldexp(position, -level))); }

Cell cellAt(const dvec3& position, int level) {
    return {level, cellOf(position.x, level), cellOf(position.y, level), cellOf(position.z, level)};
}

/// The grid of a box: its cells are two to four times as long as its longest side, but never so small that a place in the box had more
/// cells from the origin than 2^62.
int levelOf(const Bounds& box) {
    const dvec3 size = box.upperWorld - box.lowerWorld;
    const dvec3 far = glm::max(glm::abs(box.lowerWorld), glm::abs(box.upperWorld));
    const double longest = std::max(size.x, std::max(size.y, size.z));
    const double least = std::ldexp(std::max(far.x, std::max(far.y, far.z)), -60);
    return std::ilogb(std::max({longest, least, 1e-300})) + 2;
}

template <typename Visit>
void forEachCell(const Bounds& box, int level, const Visit& visit) {
    const Cell first = cellAt(box.lowerWorld, level), last = cellAt(box.upperWorld, level);
    for (std::int64_t x = first.x; x <= last.x; ++x)
        for (std::int64_t y = first.y; y <= last.y; ++y)
            for (std::int64_t z = first.z; z <= last.z; ++z)
                visit(Cell{level, x, y, z});
}

} // namespace

void forEachTouchingPair(std::span<const Bounds> boxes, const std::function<void(std::uint32_t, std::uint32_t)>& visit) {
    std::vector<int> levels;
    levels.reserve(boxes.size());
    for (const Bounds& box : boxes)
        levels.push_back(levelOf(box));
    std::vector<int> grids = levels;
    std::ranges::sort(grids);
    grids.erase(std::ranges::unique(grids).begin(), grids.end());

    // The boxes of a cell are a list: the cell has the number of its first entry, each entry that of the next.
    struct Entry {
        std::uint32_t box, next;
    };
    constexpr std::uint32_t kEnd = ~std::uint32_t{0};
    std::vector<Entry> entries;
    entries.reserve(2 * boxes.size());
    std::unordered_map<Cell, std::uint32_t, CellHash> firstOfCell;
    firstOfCell.reserve(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        forEachCell(boxes[i], levels[i], [&](const Cell& cell) {
            std::uint32_t& first = firstOfCell.try_emplace(cell, kEnd).first->second;
            entries.push_back({i, first});
            first = static_cast<std::uint32_t>(entries.size() - 1);
        });

    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        for (auto level = std::ranges::lower_bound(grids, levels[i]); level != grids.end(); ++level)
            forEachCell(boxes[i], *level, [&](const Cell& cell) {
                const auto found = firstOfCell.find(cell);
                for (std::uint32_t e = found == firstOfCell.end() ? kEnd : found->second; e != kEnd; e = entries[e].next) {
                    const std::uint32_t j = entries[e].box;
                    if (j == i || (levels[j] == levels[i] && j < i) || !touch(boxes[i], boxes[j])) continue;
                    // Two may share several cells: counted is the one with the lower corner of what they share.
                    if (cellAt(glm::max(boxes[i].lowerWorld, boxes[j].lowerWorld), *level) != cell) continue;
                    visit(std::min(i, j), std::max(i, j));
                }
            });
}

} // namespace shadowlab::scene
