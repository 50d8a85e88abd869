// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/coincident/touching_boxes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "techniques/foundation/base/mixed_bits.h"

namespace shadowlab::scene {

namespace {

using Place = glm::tvec3<std::int64_t>; ///< of a cell: sides from the origin along each axis

/// A grid of cells that share a size.
struct Grid {
    int level;            ///< the side of a cell is two to this power, metres
    double cellsPerMetre; ///< two to the power of -level
    explicit Grid(int of) : level(of), cellsPerMetre(std::ldexp(1.0, -of)) {}

    [[nodiscard]] Place cellAt(const dvec3& position) const {
        return {floorOf(position.x * cellsPerMetre), floorOf(position.y * cellsPerMetre), floorOf(position.z * cellsPerMetre)};
    }

    template <typename Visit>
    void forEachCell(const Bounds& box, const Visit& visit) const {
        const Place first = cellAt(box.lowerWorld), last = cellAt(box.upperWorld);
        for (std::int64_t x = first.x; x <= last.x; ++x)
            for (std::int64_t y = first.y; y <= last.y; ++y)
                for (std::int64_t z = first.z; z <= last.z; ++z)
                    visit(Place(x, y, z));
    }

private:
    /// As std::floor, without the call that costs more than all the rest.
    static std::int64_t floorOf(double value) {
        const auto towardZero = static_cast<std::int64_t>(value);
        return towardZero - (static_cast<double>(towardZero) > value ? 1 : 0);
    }
};

/// The grid of a box: its cells are up to twice as long as its longest side, but never so small that a place in the box had more cells
/// from the origin than 2^62.
int levelOf(const Bounds& box) {
    const dvec3 size = box.upperWorld - box.lowerWorld;
    const dvec3 far = glm::max(glm::abs(box.lowerWorld), glm::abs(box.upperWorld));
    const double longest = std::max(size.x, std::max(size.y, size.z));
    const double least = std::max(far.x, std::max(far.y, far.z)) * 0x1p-60;
    return std::ilogb(std::max({longest, least, 1e-300})) + 1;
}

/// The boxes of each cell of any grid: lists, each in descending order if boxes are entered in ascending order.
class BoxesOfCells {
public:
    static constexpr std::uint32_t kEnd = ~std::uint32_t{0};
    struct Entry {
        std::uint32_t box, next; ///< the list goes on with entry `next`
    };

    explicit BoxesOfCells(std::size_t boxes) : slots_(std::bit_ceil(4 * boxes + 1), kEnd) {
        entries_.reserve(2 * boxes);
        cells_.reserve(boxes);
    }

    void enter(std::uint32_t box, int level, const Place& place) {
        std::uint32_t& slot = slotOf(level, place);
        if (slot == kEnd) {
            slot = static_cast<std::uint32_t>(cells_.size());
            cells_.push_back({place, level, kEnd});
        }
        Cell& cell = cells_[slot];
        entries_.push_back({box, cell.first});
        cell.first = static_cast<std::uint32_t>(entries_.size() - 1);
        if (2 * cells_.size() > slots_.size()) grow();
    }

    /// The first entry of the cell's list; kEnd: no box lies there.
    [[nodiscard]] std::uint32_t firstOf(int level, const Place& place) {
        const std::uint32_t slot = slotOf(level, place);
        return slot == kEnd ? kEnd : cells_[slot].first;
    }
    [[nodiscard]] const Entry& entry(std::uint32_t number) const { return entries_[number]; }

private:
    struct Cell {
        Place place;
        int level;
        std::uint32_t first;
    };

    /// The slot that holds the cell's number, or the empty one where it belongs: a hash table with linear probing.
    [[nodiscard]] std::uint32_t& slotOf(int level, const Place& place) {
        std::uint64_t hash = static_cast<std::uint64_t>(level);
        for (int axis = 0; axis < 3; ++axis)
            hash = hashedWith(hash, static_cast<std::uint64_t>(place[axis]));
        for (std::size_t at = hash;; ++at) {
            std::uint32_t& slot = slots_[at & (slots_.size() - 1)];
            if (slot == kEnd || (cells_[slot].level == level && cells_[slot].place == place)) return slot;
        }
    }

    void grow() {
        slots_.assign(2 * slots_.size(), kEnd);
        for (std::uint32_t i = 0; i < cells_.size(); ++i)
            slotOf(cells_[i].level, cells_[i].place) = i;
    }

    std::vector<Entry> entries_;
    std::vector<Cell> cells_;
    std::vector<std::uint32_t> slots_; ///< their number is a power of two; at most half of them are taken
};

} // namespace

void forEachTouchingPair(std::span<const Bounds> boxes, const std::function<void(std::uint32_t, std::uint32_t)>& visit) {
    std::vector<int> levels;
    levels.reserve(boxes.size());
    for (const Bounds& box : boxes)
        levels.push_back(levelOf(box));
    std::vector<int> sorted = levels;
    std::ranges::sort(sorted);
    sorted.erase(std::ranges::unique(sorted).begin(), sorted.end());
    const std::vector<Grid> grids(sorted.begin(), sorted.end());
    const auto gridOf = [&](std::uint32_t box) { return std::ranges::lower_bound(grids, levels[box], {}, &Grid::level); };

    BoxesOfCells boxesOfCells(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        gridOf(i)->forEachCell(boxes[i], [&](const Place& place) { boxesOfCells.enter(i, levels[i], place); });

    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        for (auto grid = gridOf(i); grid != grids.end(); ++grid)
            grid->forEachCell(boxes[i], [&](const Place& place) {
                const bool isOwn = grid->level == levels[i];
                for (std::uint32_t e = boxesOfCells.firstOf(grid->level, place); e != BoxesOfCells::kEnd; e = boxesOfCells.entry(e).next) {
                    const std::uint32_t j = boxesOfCells.entry(e).box;
                    if (isOwn && j <= i) break; // itself, and those that have looked for this one
                    if (!touch(boxes[i], boxes[j])) continue;
                    // Two may share several cells: counted is the one with the lower corner of what they share.
                    if (grid->cellAt(glm::max(boxes[i].lowerWorld, boxes[j].lowerWorld)) != place) continue;
                    visit(std::min(i, j), std::max(i, j));
                }
            });
}

} // namespace shadowlab::scene
