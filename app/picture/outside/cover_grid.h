// What is drawn where in a picture, roughly: a grid of cells, each with the set of things that touch it. Labels are placed by it.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::picture {

/// A rectangle in pixels from the picture's upper left corner.
struct PixelBox {
    dvec2 lower{0.0}, upper{0.0};
    [[nodiscard]] bool overlaps(const PixelBox& other, double gap = 0) const {
        return lower.x < other.upper.x + gap && other.lower.x < upper.x + gap && lower.y < other.upper.y + gap &&
               other.lower.y < upper.y + gap;
    }
    [[nodiscard]] bool holds(const dvec2& point) const {
        return point.x >= lower.x && point.x <= upper.x && point.y >= lower.y && point.y <= upper.y;
    }
    [[nodiscard]] dvec2 nearest(const dvec2& point) const { return glm::clamp(point, lower, upper); }
    [[nodiscard]] dvec2 middle() const { return 0.5 * (lower + upper); }
};

/// The part of a segment within a box; false when there is none. Liang and Barsky, 1984.
bool cutToBox(dvec2& from, dvec2& to, const PixelBox& box);

class CoverGrid {
public:
    static constexpr int kMostThings = 64; ///< further ones are not entered

    CoverGrid(ivec2 pictureSize, double cellPixels);
    // Things are numbered from 0. Coordinates are pixels from the upper left corner; what lies beside the picture is cut off.
    void addLine(dvec2 from, dvec2 to, std::size_t thing);
    void addTriangle(const std::array<dvec2, 3>& corners, std::size_t thing);

    [[nodiscard]] ivec2 cells() const { return cells_; }
    [[nodiscard]] dvec2 middleOf(ivec2 cell) const { return (dvec2(cell) + 0.5) * cellPixels_; }
    [[nodiscard]] ivec2 cellAt(const dvec2& pixel) const;
    /// Has the thing a face in the cell?
    [[nodiscard]] bool hasFace(ivec2 cell, std::size_t thing) const;
    /// How many other things have a line, and how many a face, in the cell.
    [[nodiscard]] int otherLines(ivec2 cell, std::size_t thing) const;
    [[nodiscard]] int otherFaces(ivec2 cell, std::size_t thing) const;
    /// Share of the box's cells in which any line is drawn, and in which a face is drawn of another thing.
    [[nodiscard]] double lineShare(const PixelBox& box) const;
    [[nodiscard]] double otherFaceShare(const PixelBox& box, std::size_t thing) const;
    /// Whether all of the box's cells have a face of the thing.
    [[nodiscard]] bool isOnFace(const PixelBox& box, std::size_t thing) const;

private:
    [[nodiscard]] std::size_t index(ivec2 cell) const {
        return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(cells_.x) + static_cast<std::size_t>(cell.x);
    }
    template <typename Test>
    [[nodiscard]] double share(const PixelBox& box, const Test& test) const;
    double cellPixels_;
    ivec2 cells_;
    dvec2 pictureSize_;
    std::vector<std::uint64_t> lines_, faces_; ///< a bit for each thing
};

} // namespace shadowlab::picture
