// SPDX-License-Identifier: MIT
#include <numeric>

#include "techniques/foundation/trace/structures/grid.h"

namespace shadowlab::trace {

namespace {

// Cells per triangle. The time of a ray grows with the cells along it, and falls with the triangles in each; the least
// lies where there are a few cells to a triangle, and is flat (Cleary and Wyvill, "Analysis of an Algorithm for Fast Ray
// Tracing Using Uniform Space Subdivision", The Visual Computer 1988).
constexpr double kCellsPerTriangle = 4;
constexpr double kMostCells = 64e6; // a quarter of a gigabyte of them, where there are more triangles

// Entries per triangle in all lists together. Ordinary meshes have three or four; where large triangles lie in many cells
// each, coarser cells cost less than the memory.
constexpr double kEntriesPerTriangle = 16;

// The margin as a share of the grid's size: far beyond rounding, far below the size of a cell.
constexpr double kCellMargin = 0x1p-20;

constexpr std::size_t kTrianglesPerSlice = 4096; // between two readings of the clock

class GridEngine final : public WalkingEngine<GridEngine> {
public:
    explicit GridEngine(const EngineInput& input) : WalkingEngine(input), grid_(input) {}
    bool advance(Deadline deadline) override { return grid_.advance(deadline); }
    [[nodiscard]] double done() const override { return grid_.done(); }

    template <typename Query, typename Count>
    void visit(const Ray& ray, Query& query, Count count) const {
        grid_.visit(ray, query, count);
    }

    [[nodiscard]] std::size_t bytes() const override { return grid_.bytes(); }
    /// The cells that hold three triangles or more, or else something; if they are too many, blocks of 2^3, 4^3 ... cells
    /// that do. Walls and floors, which are two triangles, would hide all the others.
    [[nodiscard]] std::vector<StructurePart> parts(std::size_t most) const override;
    [[nodiscard]] std::vector<StructurePart> passed(const Ray& ray, std::size_t most) const override;
    [[nodiscard]] std::optional<StructureCells> cells() const override {
        const ivec3 last = grid_.counts() - 1;
        return StructureCells{grid_.cellBox(ivec3(0)).lowerCentred, grid_.cellBox(last).upperCentred, grid_.counts()};
    }

private:
    Grid grid_;
};

std::vector<StructurePart> GridEngine::parts(std::size_t most) const {
    const ivec3 counts = grid_.counts();
    const auto forAll = [](ivec3 size, const auto& work) {
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    work(ivec3(x, y, z));
    };
    std::size_t least = 1;
    forAll(counts, [&](ivec3 cell) { least = grid_.trianglesIn(cell).size() >= 3 ? 3 : least; });
    for (int side = 1;; side *= 2) {
        const ivec3 blocks = (counts + ivec3(side - 1)) / side;
        std::vector<std::uint8_t> holds(static_cast<std::size_t>(blocks.x) * static_cast<std::size_t>(blocks.y) *
                                        static_cast<std::size_t>(blocks.z));
        const auto indexOf = [&](ivec3 b) { return static_cast<std::size_t>((b.z * blocks.y + b.y) * blocks.x + b.x); };
        forAll(counts, [&](ivec3 cell) {
            if (grid_.trianglesIn(cell).size() >= least) holds[indexOf(cell / side)] = 1;
        });
        std::vector<StructurePart> parts;
        forAll(blocks, [&](ivec3 block) {
            if (!holds[indexOf(block)]) return;
            const dvec3 lower = grid_.cellBox(block * side).lowerCentred;
            const dvec3 upper = grid_.cellBox(glm::min(block * side + side, counts) - 1).upperCentred;
            parts.push_back({false, 0, lower, upper, {}, 0});
        });
        if (parts.size() <= most || side >= std::max({counts.x, counts.y, counts.z})) return parts;
    }
}

} // namespace

Grid::Grid(const EngineInput& input)
    : input_(input), finite_(finiteTriangles(input.triangles, 0, input.triangles.size())) {
    for (const std::uint32_t p : finite_)
        box_.include(input.triangles[p]);
    if (finite_.empty()) {
        box_ = {dvec3(0), dvec3(0)};
        stage_ = Stage::finished;
        starts_ = {0, 0};
        return;
    }
    const dvec3 extent = box_.upperCentred - box_.lowerCentred;
    const dvec3 largest = glm::max(glm::abs(box_.lowerCentred), glm::abs(box_.upperCentred));
    // Where all lies in one point far out, the margin still has to be more than its coordinates' rounding.
    margin_ = std::max(kCellMargin * std::max({extent.x, extent.y, extent.z}),
                       0x1p-40 * std::max({largest.x, largest.y, largest.z, 0x1p-900}));
    box_.lowerCentred -= 2 * margin_;
    box_.upperCentred += 2 * margin_;
    chooseCounts();
    starts_.assign(cellCount() + 1, 0);
}

/// Halves the cells across their longest side until there are enough; takes back what makes the lists too long.
void Grid::chooseCounts() {
    const dvec3 extent = box_.upperCentred - box_.lowerCentred;
    const auto setCounts = [&](ivec3 counts) {
        counts_ = counts;
        cellSize_ = extent / dvec3(counts);
    };
    std::vector<ivec3> tried{ivec3(1)};
    const double wanted = std::min(kMostCells, kCellsPerTriangle * static_cast<double>(finite_.size()));
    for (setCounts(tried.back()); static_cast<double>(cellCount()) < wanted; setCounts(tried.back())) {
        ivec3 finer = counts_;
        const dvec3 s = cellSize_;
        finer[s.x > s.y ? (s.x > s.z ? 0 : 2) : (s.y > s.z ? 1 : 2)] *= 2;
        tried.push_back(finer);
    }
    const auto entries = [&] {
        double sum = 0;
        for (const std::uint32_t p : finite_) {
            const auto [first, last] = cellsOf(p);
            const dvec3 count(last - first + 1);
            sum += count.x * count.y * count.z;
        }
        return sum;
    };
    while (tried.size() > 1 && entries() > kEntriesPerTriangle * static_cast<double>(finite_.size())) {
        tried.pop_back();
        setCounts(tried.back());
    }
}

std::pair<ivec3, ivec3> Grid::cellsOf(std::uint32_t primitive) const {
    Box box;
    box.include(input_.triangles[primitive]);
    return {cellAt(box.lowerCentred - margin_), cellAt(box.upperCentred + margin_)};
}

std::vector<StructurePart> GridEngine::passed(const Ray& ray, std::size_t most) const {
    std::vector<StructurePart> passed;
    if (!isUsable(ray)) return passed;
    const ShearedRay sheared(ray);
    auto walk = grid_.begin(sheared, sheared.farthest);
    while (walk && passed.size() < most) {
        const Box box = grid_.cellBox(walk->cell);
        const std::span<const std::uint32_t> listed = grid_.trianglesIn(walk->cell);
        passed.push_back({.lowerCentred = box.lowerCentred,
                          .upperCentred = box.upperCentred,
                          .primitives = {listed.begin(), listed.end()}});
        if (sheared.farthest < walk->leave[walk->nextAxis()] || !grid_.next(*walk)) break;
    }
    return passed;
}

template <typename Work>
void Grid::forCellsOf(std::uint32_t primitive, const Work& work) const {
    const auto [first, last] = cellsOf(primitive);
    for (int z = first.z; z <= last.z; ++z)
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x)
                work(indexOf({x, y, z}));
}

/// Counts what each cell will list, makes room, then fills the lists from their ends, so that each rises.
bool Grid::advance(Engine::Deadline deadline) {
    while (stage_ != Stage::finished) {
        const std::size_t end = std::min(finite_.size(), handled_ + kTrianglesPerSlice);
        for (; handled_ < end; ++handled_) {
            if (stage_ == Stage::counting)
                forCellsOf(finite_[handled_], [&](std::size_t cell) { ++starts_[cell]; });
            else {
                const std::uint32_t primitive = finite_[finite_.size() - 1 - handled_];
                forCellsOf(primitive, [&](std::size_t cell) { lists_[--starts_[cell]] = primitive; });
            }
        }
        if (handled_ == finite_.size()) {
            if (stage_ == Stage::counting) {
                std::partial_sum(starts_.begin(), starts_.end(), starts_.begin()); // now the ends of the lists
                lists_.resize(starts_.back());
            }
            stage_ = stage_ == Stage::counting ? Stage::filling : Stage::finished;
            handled_ = 0;
        }
        if (stage_ != Stage::finished && std::chrono::steady_clock::now() >= deadline) return false;
    }
    return true;
}

double Grid::done() const {
    if (stage_ == Stage::finished) return 1.0;
    const double share = static_cast<double>(handled_) / static_cast<double>(finite_.size());
    return stage_ == Stage::counting ? 0.5 * share : 0.5 + 0.5 * share;
}

std::optional<Grid::Walk> Grid::begin(const ShearedRay& ray, double farthest) const {
    const VolumeRay volumes(ray);
    const double enter = volumes.enter(box_, farthest);
    if (finite_.empty() || enter == kNowhere) return std::nullopt;
    Walk walk{};
    walk.origin = ray.originCentred;
    walk.inverse = ray.reachPerT / ray.directionCentred;
    walk.cell = cellAt(ray.originCentred + std::max(enter, 0.0) * (ray.directionCentred / ray.reachPerT));
    for (int axis = 0; axis < 3; ++axis) {
        const double d = ray.directionCentred[axis];
        const bool moves = d != 0 && std::isfinite(walk.inverse[axis]); // else it never leaves its layer of cells
        walk.step[axis] = !moves ? 0 : d > 0 ? 1 : -1;
        walk.leave[axis] = crossing(walk, axis);
    }
    return walk;
}

std::unique_ptr<Engine> makeGrid(const EngineInput& input) { return std::make_unique<GridEngine>(input); }

} // namespace shadowlab::trace
