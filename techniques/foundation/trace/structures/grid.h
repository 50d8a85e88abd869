// Uniform subdivision: the scene's box is cut into equal cells, each with a list of the triangles that may reach into it. A
// ray walks from cell to cell, in order, and ends in the first in which it hits something (Fujimoto, Tanaka and Iwata, "ARTS:
// Accelerated Ray-Tracing System", 1986; the walk after Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray
// Tracing", Eurographics 1987).
//
// What rounding does to the walk. Where the ray crosses a plane of cells is computed anew for each plane, not by adding
// steps that drift; a position on the way is then wrong by less than 8 e times the way from the ray's origin, e = 2^-53. Every
// triangle is listed in the cells that its box touches when grown by a margin, which is more than that: so it is found in
// the cell where the walk stands when it passes the hit, also when the ray runs through edges and corners of cells, and
// which of two cells the walk takes there does not matter. Rays that begin so far away that the margin would not do try
// all triangles.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>

#include "techniques/foundation/trace/ray_query.h"
#include "techniques/foundation/trace/structures/ray_volumes.h"

namespace shadowlab::trace {

using glm::ivec3;

/// Remembers which triangles a ray has tried: a large one is listed in many cells. A few slots, each for one triangle in
/// every 64: an overwritten slot only means that a triangle is tested twice; the slots belong to the ray, so threads share
/// nothing (Benthin, "Realtime Ray Tracing on Current CPU Architectures", 2006).
class Mailboxes {
public:
    Mailboxes() { slots_.fill(kNoPrimitive); }
    bool knows(std::uint32_t primitive) {
        std::uint32_t& slot = slots_[primitive % slots_.size()];
        if (slot == primitive) return true;
        slot = primitive;
        return false;
    }

private:
    std::array<std::uint32_t, 64> slots_;
};

class Grid {
public:
    explicit Grid(const EngineInput& input);
    /// Goes on building until it is finished (true) or the time has come (false), but always a bit.
    bool advance(Engine::Deadline deadline);
    [[nodiscard]] double done() const;

    /// Names the triangles along the ray to the query, cell by cell.
    template <typename Query, typename Count>
    void visit(const Ray& ray, Query& query, Count count) const;

    [[nodiscard]] const Box& box() const { return box_; }
    [[nodiscard]] ivec3 counts() const { return counts_; } ///< of cells along each axis
    [[nodiscard]] Box cellBox(ivec3 cell) const { return {planes(cell), planes(cell + ivec3(1))}; }
    [[nodiscard]] std::span<const std::uint32_t> trianglesIn(ivec3 cell) const {
        const std::size_t i = indexOf(cell);
        return std::span(lists_).subspan(starts_[i], starts_[i + 1] - starts_[i]);
    }
    [[nodiscard]] std::size_t bytes() const {
        return (lists_.size() + starts_.size() + finite_.size()) * sizeof(std::uint32_t);
    }
    [[nodiscard]] std::size_t entries() const { return lists_.size(); }

    /// Where a ray stands: its cell, and in units of reach where it leaves that one along each axis.
    struct Walk {
        ivec3 cell, step;
        dvec3 leave, origin, inverse;
        /// The axis of the next plane; of equally near ones the first.
        [[nodiscard]] int nextAxis() const {
            return leave.x <= leave.y ? (leave.x <= leave.z ? 0 : 2) : (leave.y <= leave.z ? 1 : 2);
        }
    };
    /// Nothing where the ray misses the grid before `farthest`.
    [[nodiscard]] std::optional<Walk> begin(const ShearedRay& ray, double farthest) const;
    /// Into the next cell; false: out of the grid.
    bool next(Walk& walk) const {
        const int axis = walk.nextAxis();
        walk.cell[axis] += walk.step[axis];
        if (walk.cell[axis] < 0 || walk.cell[axis] >= counts_[axis]) return false;
        walk.leave[axis] = crossing(walk, axis);
        return true;
    }

private:
    [[nodiscard]] std::size_t indexOf(ivec3 cell) const {
        return (static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(counts_.y) +
                static_cast<std::size_t>(cell.y)) *
                   static_cast<std::size_t>(counts_.x) +
               static_cast<std::size_t>(cell.x);
    }
    [[nodiscard]] dvec3 planes(ivec3 index) const { return box_.lowerCentred + dvec3(index) * cellSize_; }
    [[nodiscard]] double crossing(const Walk& walk, int axis) const {
        if (walk.step[axis] == 0) return kNowhere;
        const int plane = walk.cell[axis] + (walk.step[axis] > 0 ? 1 : 0);
        return (box_.lowerCentred[axis] + plane * cellSize_[axis] - walk.origin[axis]) * walk.inverse[axis];
    }
    void chooseCounts();
    [[nodiscard]] std::size_t cellCount() const {
        return static_cast<std::size_t>(counts_.x) * static_cast<std::size_t>(counts_.y) *
               static_cast<std::size_t>(counts_.z);
    }
    [[nodiscard]] ivec3 cellAt(const dvec3& p) const {
        const dvec3 at = glm::floor((p - box_.lowerCentred) / cellSize_);
        return ivec3(glm::clamp(at, dvec3(0), dvec3(counts_ - 1)));
    }
    /// The first and the last of the cells that list a triangle.
    [[nodiscard]] std::pair<ivec3, ivec3> cellsOf(std::uint32_t primitive) const;
    template <typename Work>
    void forCellsOf(std::uint32_t primitive, const Work& work) const;

    EngineInput input_;
    std::vector<std::uint32_t> finite_; ///< triangles that can be hit
    Box box_;
    double margin_ = 0;
    ivec3 counts_{1};
    dvec3 cellSize_{1.0};
    std::vector<std::uint32_t> starts_; ///< of each cell's list; one more
    std::vector<std::uint32_t> lists_;
    enum class Stage { counting, filling, finished } stage_ = Stage::counting;
    std::size_t handled_ = 0; ///< triangles, in this stage
};

template <typename Query, typename Count>
void Grid::visit(const Ray&, Query& query, Count count) const {
    const auto tryOne = [&](std::uint32_t primitive) {
        count.triangles(1);
        query.tryTriangle(primitive);
    };
    const dvec3 away = glm::abs(query.sheared.originCentred);
    if (std::max({away.x, away.y, away.z}) > 0x1p48 * margin_) { // a quarter of margin / 8 e, see above
        for (std::size_t i = 0; i < finite_.size() && !query.isAnswered(); ++i)
            tryOne(finite_[i]);
        return;
    }
    auto walk = begin(query.sheared, query.farthest());
    if (!walk) return;
    Mailboxes mailboxes;
    do {
        count.step();
        for (const std::uint32_t primitive : trianglesIn(walk->cell)) {
            if (mailboxes.knows(primitive)) continue;
            tryOne(primitive);
            if (query.isAnswered()) return;
        }
        // A triangle of this cell may be hit in a later one, and there something nearer: the walk ends only when the hit
        // lies in the cells seen so far.
        if (query.farthest() < walk->leave[walk->nextAxis()]) return;
    } while (next(*walk));
}

} // namespace shadowlab::trace
