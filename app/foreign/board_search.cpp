// Both are reduced to some thousand points; the correlation of their greys is asked for each orientation and scale.
// SPDX-License-Identifier: MIT
#include "app/foreign/board_search.h"

#include <algorithm>
#include <cmath>

#include "app/foreign/statistics.h"
#include "app/judge/grid.h"

namespace shadowlab::foreign {

namespace {

constexpr int kRows = 36; // of the smaller side: the smallest square is four points wide

judge::Grid<float> reducedPicture(const image::Image& picture) {
    const double cell = static_cast<double>(std::min(picture.width, picture.height)) / kRows;
    judge::Grid<float> sums(static_cast<int>(std::round(picture.width / cell)), static_cast<int>(std::round(picture.height / cell)));
    judge::Grid<float> counts(sums.width, sums.height);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const int column = std::min(x * sums.width / picture.width, sums.width - 1);
            const int row = std::min(y * sums.height / picture.height, sums.height - 1);
            const image::Color8 color = picture.at(x, y);
            sums.at(column, row) += static_cast<float>(color.r + color.g + color.b) / (3 * 255.0f);
            counts.at(column, row) += 1;
        }
    for (std::size_t i = 0; i < sums.values.size(); ++i)
        sums.values[i] /= std::max(counts.values[i], 1.0f);
    return sums;
}

bool isInside(const BoardPatch& patch, const dvec2& pointPx) {
    const dvec2 from = pointPx - patch.centrePx;
    const double angle = glm::radians(patch.turnedDegrees), c = std::cos(angle), s = std::sin(angle);
    // Counter-clockwise as seen, with y downward.
    const dvec2 own(from.x * c - from.y * s, from.x * s + from.y * c);
    return std::abs(own.x) <= 0.5 * patch.sizePx.x && std::abs(own.y) <= 0.5 * patch.sizePx.y;
}

constexpr float kOfCode = -1; ///< a point of the code's cells, which differ from camera to camera

/// The board's greys, sRGB-encoded, at points four times as dense.
judge::Grid<float> boardPoints(const BoardLayout& board, ivec2 size, ivec2 points) {
    judge::Grid<float> greys(points.x, points.y);
    const std::vector<BoardPatch> patches = board.all();
    for (int y = 0; y < points.y; ++y)
        for (int x = 0; x < points.x; ++x) {
            const dvec2 place = (dvec2(x, y) + 0.5) / dvec2(points) * dvec2(size);
            for (const BoardPatch& patch : patches)
                if (isInside(patch, place)) {
                    double grey = 0;
                    for (int channel = 0; channel < 3; ++channel)
                        grey += encodedWith(ToneCurve::srgb, patch.radiance[channel]) / 3;
                    greys.at(x, y) = static_cast<float>(grey);
                }
            for (const auto& cells : board.code)
                if (isInside(cells[0], place) || isInside(cells[1], place)) greys.at(x, y) = kOfCode;
        }
    return greys;
}

/// The correlation between the picture and the board, laid into it with that scale and shift.
double likeness(const judge::Grid<float>& seen, const judge::Grid<float>& board, const Orientation& orientation, const dvec2& scale, const dvec2& shift) {
    Correlation correlation;
    for (int y = 0; y < seen.height; ++y)
        for (int x = 0; x < seen.width; ++x) {
            dvec2 from = (dvec2(x, y) + 0.5) / dvec2(seen.width, seen.height) - 0.5; // shares of the picture
            if (orientation.mirrorsX) from.x = -from.x;
            if (orientation.mirrorsY) from.y = -from.y;
            if (orientation.swapsAxes) std::swap(from.x, from.y);
            const dvec2 place = ((from - shift) / scale + 0.5) * dvec2(board.width, board.height);
            const ivec2 point(glm::floor(place));
            const bool within = point.x >= 0 && point.y >= 0 && point.x < board.width && point.y < board.height;
            const float expected = within ? board.at(point.x, point.y) : 0.0f;
            if (expected != kOfCode) correlation.add(static_cast<double>(seen.at(x, y)), static_cast<double>(expected));
        }
    return correlation.value();
}

} // namespace

BoardMatch searchBoard(const image::Image& picture, const BoardLayout& board, ivec2 size) {
    const judge::Grid<float> seen = reducedPicture(picture);
    const judge::Grid<float> points = boardPoints(board, size, 4 * ivec2(seen.width, seen.height));
    BoardMatch best;
    best.likeness = -1;
    const auto attempt = [&](const Orientation& orientation, const dvec2& scale, const dvec2& shift) {
        const double found = likeness(seen, points, orientation, scale, shift);
        if (found > best.likeness) best = {orientation, scale, shift, found};
    };
    const auto oriented = [](int i) { return Orientation{.swapsAxes = (i & 4) != 0, .mirrorsX = (i & 1) != 0, .mirrorsY = (i & 2) != 0}; };
    const int orientations = size.x == size.y ? 8 : 4;
    for (int i = 0; i < orientations; ++i)
        attempt(oriented(i), dvec2(1.0), dvec2(0.0));
    // A twelfth of an octave moves the squares by a third of their size at most.
    constexpr int kSteps = 12;
    if (best.likeness < 0.95) // at the right scale, whatever the encoding, it is more
        for (int i = 0; i < orientations; ++i)
            for (int x = -kSteps; x <= kSteps; ++x)
                for (int y = -kSteps; y <= kSteps; ++y)
                    attempt(oriented(i), {std::exp2(static_cast<double>(x) / kSteps), std::exp2(static_cast<double>(y) / kSteps)}, dvec2(0.0));
    // From elsewhere the board is moved, and hardly stretched along one axis alone. A step is a third of a middling square.
    constexpr int kShifts = 6;
    constexpr double kMostShift = 0.25;
    const bool isMoved = best.likeness < 0.9; // the nearest of these scales leaves no less
    if (isMoved)
        for (int i = 0; i < orientations; ++i)
            for (int scale = -kSteps; scale <= kSteps; scale += 2)
                for (int x = -kShifts; x <= kShifts; ++x)
                    for (int y = -kShifts; y <= kShifts; ++y)
                        attempt(oriented(i), dvec2(std::exp2(static_cast<double>(scale) / kSteps)), kMostShift * dvec2(x, y) / static_cast<double>(kShifts));
    for (double step = 1.0 / kSteps; step > 0.005; step /= 2) {
        for (const dvec2 change : {dvec2(-1, 0), dvec2(1, 0), dvec2(0, -1), dvec2(0, 1), dvec2(-1, -1), dvec2(1, 1)}) {
            const BoardMatch coarse = best;
            attempt(coarse.orientation, coarse.scale * glm::exp2(step * change), coarse.shift);
            if (isMoved) attempt(coarse.orientation, coarse.scale, coarse.shift + 0.5 * step * change);
        }
    }
    return best;
}

} // namespace shadowlab::foreign
