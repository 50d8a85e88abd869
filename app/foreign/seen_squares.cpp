// SPDX-License-Identifier: MIT
#include "app/foreign/seen_squares.h"

#include <algorithm>
#include <cmath>

#include "app/foreign/calibration_reading.h"

namespace shadowlab::foreign {

namespace {

double brightnessAt(const image::Image& picture, int x, int y) {
    const image::Color8 color = picture.at(x, y);
    return (color.r + color.g + color.b) / (3 * 255.0);
}

struct BrightSpot {
    dvec2 centrePx{0.0};
    double areaPx = 0;
    bool isCut = false; ///< some of it lies on the picture's edge
};

/// Centre of gravity and area of what is brighter than its surroundings in a box; nothing where the box lies outside.
std::optional<BrightSpot> brightSpot(const image::Image& picture, const dvec2& centrePx, const dvec2& halfPx) {
    const ivec2 end(picture.width, picture.height);
    const ivec2 from = glm::clamp(ivec2(glm::floor(centrePx - halfPx)), ivec2(0), end), to = glm::clamp(ivec2(glm::ceil(centrePx + halfPx)), ivec2(0), end);
    if (from.x >= to.x || from.y >= to.y) return std::nullopt;
    double most = 0, least = 1;
    for (int y = from.y; y < to.y; ++y)
        for (int x = from.x; x < to.x; ++x) {
            most = std::max(most, brightnessAt(picture, x, y));
            least = std::min(least, brightnessAt(picture, x, y));
        }
    // Noise of the background is left out; the square is all white, so what remains is symmetric.
    constexpr double kNoise = 0.08;
    BrightSpot spot;
    dvec2 sum(0.0);
    for (int y = from.y; y < to.y; ++y)
        for (int x = from.x; x < to.x; ++x) {
            const double share = (brightnessAt(picture, x, y) - least) / std::max(most - least, 1e-9);
            if (share < kNoise) continue;
            // Coverage is a share of light, so the number is decoded first; a wrong curve changes both sides of a square alike.
            const double light = image::linearFromEncoded(share);
            sum += light * dvec2(x + 0.5, y + 0.5);
            spot.areaPx += light;
            if (x == 0 || y == 0 || x == end.x - 1 || y == end.y - 1) spot.isCut = true;
        }
    if (spot.areaPx <= 0) return std::nullopt;
    spot.centrePx = sum / spot.areaPx;
    return spot;
}

/// Is it as large as the square should be? Something else is, or a part of it.
bool isAsLargeAs(const BrightSpot& spot, const dvec2& sidesPx) {
    // A fifth for a scale that is not yet known well, and a quarter of a pixel along the edges for their encoding.
    const double area = sidesPx.x * sidesPx.y;
    return std::abs(spot.areaPx - area) < 0.2 * area + 0.5 * (sidesPx.x + sidesPx.y);
}

} // namespace

std::vector<SeenSquare> wholeSquares(const image::Image& picture, const BoardLayout& board, ivec2 size, const Placement& placed, double marginPx) {
    std::vector<SeenSquare> seen;
    const double turned = glm::radians(kTurnedDegrees);
    const dvec2 scale(glm::length(placed.perX), glm::length(placed.perY));
    constexpr double kLeastSidePx = 5; // of fewer rows, sampled once, the middle is not known to a tenth of a pixel
    for (std::size_t i = 0; i < board.squares.size(); ++i) {
        const BoardPatch& square = board.squares[i];
        if (square.sizePx.x < kLeastSidePx) continue;
        const dvec2 sides = square.sizePx * scale, half = 0.5 * sides * (std::cos(turned) + std::sin(turned));
        const dvec2 fromMiddle = square.centrePx - 0.5 * dvec2(size);
        BrightSpot spot{.centrePx = placed(fromMiddle)};
        std::optional<BrightSpot> found = spot;
        constexpr int kSteps = 10; // each brings the box nearer to the square, which it may cut at first
        for (int step = 0; step < kSteps && found; ++step)
            found = brightSpot(picture, found->centrePx, half + marginPx);
        if (found && !found->isCut && isAsLargeAs(*found, sides)) seen.push_back({i, fromMiddle, found->centrePx});
    }
    return seen;
}

std::optional<Placement> fitted(const std::vector<SeenSquare>& seen, ivec2 size) {
    if (seen.size() < 3) return std::nullopt;
    dmat3 normal(0.0);
    dvec3 right[2] = {dvec3(0.0), dvec3(0.0)};
    const dvec2 unit = 0.5 * dvec2(size); // keeps the matrix's numbers near one
    for (const SeenSquare& one : seen) {
        const dvec3 row(1.0, one.boardPx / unit);
        normal += glm::outerProduct(row, row);
        for (int axis = 0; axis < 2; ++axis)
            right[axis] += row * one.seenPx[axis];
    }
    constexpr double kSingular = 1e-9;
    if (std::abs(glm::determinant(normal)) < kSingular) return std::nullopt;
    const dmat3 inverse = glm::inverse(normal);
    const dvec3 x = inverse * right[0], y = inverse * right[1];
    const dvec2 scale(std::hypot(x[1], y[1]) / unit.x, std::hypot(x[2], y[2]) / unit.y);
    // With one sample a pixel the middle of a square of ten rows is known to this; a third of a pixel is three times what it makes of a corner.
    constexpr double kMiddlePx = 0.05;
    for (const dvec2 corner : {dvec2(-1, -1), dvec2(1, -1), dvec2(-1, 1), dvec2(1, 1)}) {
        const dvec3 row(1.0, corner / scale);
        if (!(3 * kMiddlePx * std::sqrt(glm::dot(row, inverse * row)) < kLeastCornerPx)) return std::nullopt;
    }
    return Placement{{x[0], y[0]}, {x[1] / unit.x, y[1] / unit.x}, {x[2] / unit.y, y[2] / unit.y}};
}

std::vector<SeenSquare> bestOf(const std::vector<SeenSquare>& seen) {
    constexpr std::size_t kLarge = 4; // the first of the board's
    std::vector<SeenSquare> large;
    std::ranges::copy_if(seen, std::back_inserter(large), [](const SeenSquare& one) { return one.index < kLarge; });
    return large.size() == kLarge ? large : seen;
}

double worstMissPx(const std::vector<SeenSquare>& seen, const Placement& placed) {
    double worst = 0;
    for (const SeenSquare& one : seen)
        worst = std::max(worst, glm::length(one.seenPx - placed(one.boardPx)));
    return worst;
}

} // namespace shadowlab::foreign
