// SPDX-License-Identifier: MIT
#include "app/foreign/calibration_reading.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/foreign/board_search.h"
#include "app/foreign/calibration_words.h"

namespace shadowlab::foreign {

namespace {

double greyAt(const image::Image& picture, int x, int y) {
    const image::Color8 color = picture.at(x, y);
    return (color.r + color.g + color.b) / (3 * 255.0);
}

/// Where the board's middle and axes are seen, in pixels.
struct Placement {
    dvec2 centrePx{0.0};
    dvec2 perX{1.0, 0.0}, perY{0.0, 1.0}; ///< what a pixel of the board to the right, and down, is in the picture
    [[nodiscard]] dvec2 operator()(const dvec2& fromMiddlePx) const {
        return centrePx + fromMiddlePx.x * perX + fromMiddlePx.y * perY;
    }
};

/// Centre of gravity of what is brighter than its surroundings in a box; nothing where the box leaves the picture.
std::optional<dvec2> centreOfGravity(const image::Image& picture, const dvec2& centrePx, const dvec2& halfPx) {
    const ivec2 from(glm::floor(centrePx - halfPx)), to(glm::ceil(centrePx + halfPx));
    if (from.x < 0 || from.y < 0 || to.x > picture.width || to.y > picture.height) return std::nullopt;
    double most = 0, least = 1;
    for (int y = from.y; y < to.y; ++y)
        for (int x = from.x; x < to.x; ++x) {
            most = std::max(most, greyAt(picture, x, y));
            least = std::min(least, greyAt(picture, x, y));
        }
    // Noise of the background is left out; the square is all white, so what remains is symmetric.
    constexpr double kNoise = 0.08;
    dvec2 sum(0.0);
    double weight = 0;
    for (int y = from.y; y < to.y; ++y)
        for (int x = from.x; x < to.x; ++x) {
            const double share = (greyAt(picture, x, y) - least) / std::max(most - least, 1e-9);
            if (share < kNoise) continue;
            // Coverage is a share of light, so the number is decoded first; a wrong curve changes both sides of a square alike.
            const double light = image::linearFromEncoded(share);
            sum += light * dvec2(x + 0.5, y + 0.5);
            weight += light;
        }
    if (weight <= 0) return std::nullopt;
    return sum / weight;
}

struct SeenSquare {
    dvec2 boardPx{0.0}, seenPx{0.0}; ///< from the middle of the board, and in the picture
};

std::vector<SeenSquare> squaresSeen(const image::Image& picture, const BoardLayout& board, ivec2 size, const Placement& placed,
                                    double marginPx) {
    std::vector<SeenSquare> seen;
    const double turned = glm::radians(kTurnedDegrees);
    for (const BoardPatch& square : board.squares) {
        const dvec2 scale(glm::length(placed.perX), glm::length(placed.perY));
        const dvec2 half = 0.5 * square.sizePx * (std::cos(turned) + std::sin(turned)) * scale;
        const dvec2 fromMiddle = square.centrePx - 0.5 * dvec2(size);
        std::optional<dvec2> centre = placed(fromMiddle);
        constexpr int kSteps = 4; // each brings the box nearer to the square
        for (int step = 0; step < kSteps && centre; ++step)
            centre = centreOfGravity(picture, *centre, half + marginPx);
        if (centre) seen.push_back({fromMiddle, *centre});
    }
    return seen;
}

/// Least squares: seen = centre + x perX + y perY. Two squares give scale and shift only.
Placement fitted(const std::vector<SeenSquare>& seen, const Placement& before) {
    Placement placed = before;
    if (seen.size() >= 3) {
        dmat3 normal(0.0);
        dvec3 right[2] = {dvec3(0.0), dvec3(0.0)};
        for (const SeenSquare& one : seen) {
            const dvec3 row(1.0, one.boardPx);
            normal += glm::outerProduct(row, row);
            for (int axis = 0; axis < 2; ++axis)
                right[axis] += row * one.seenPx[axis];
        }
        const dmat3 inverse = glm::inverse(normal);
        const dvec3 x = inverse * right[0], y = inverse * right[1];
        return {{x[0], y[0]}, {x[1], y[1]}, {x[2], y[2]}};
    }
    for (int axis = 0; axis < 2 && seen.size() == 2; ++axis) {
        const double board = seen[1].boardPx[axis] - seen[0].boardPx[axis];
        const double scale = std::abs(board) > 1 ? (seen[1].seenPx[axis] - seen[0].seenPx[axis]) / board
                                                 : (axis == 0 ? placed.perX.x : placed.perY.y);
        (axis == 0 ? placed.perX.x : placed.perY.y) = scale;
        placed.centrePx[axis] = seen[0].seenPx[axis] - scale * seen[0].boardPx[axis];
    }
    return placed;
}

/// The middle of a patch's numbers, per channel; nothing outside the picture.
std::optional<dvec3> numberOf(const image::Image& picture, const BoardPatch& patch, ivec2 size, const Placement& placed) {
    const dvec2 centre = placed(patch.centrePx - 0.5 * dvec2(size));
    // The inner half: antialiasing and small shifts do not reach it.
    const dvec2 half = glm::max(0.25 * patch.sizePx * dvec2(glm::length(placed.perX), glm::length(placed.perY)), dvec2(0.5));
    std::array<std::vector<double>, 3> numbers;
    for (int y = static_cast<int>(std::floor(centre.y - half.y)); y < std::ceil(centre.y + half.y); ++y)
        for (int x = static_cast<int>(std::floor(centre.x - half.x)); x < std::ceil(centre.x + half.x); ++x) {
            if (!picture.contains(x, y)) continue;
            const image::Color8 color = picture.at(x, y);
            numbers[0].push_back(color.r / 255.0);
            numbers[1].push_back(color.g / 255.0);
            numbers[2].push_back(color.b / 255.0);
        }
    if (numbers[0].empty()) return std::nullopt;
    dvec3 middle(0.0);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        std::ranges::sort(numbers[channel]);
        middle[static_cast<int>(channel)] = numbers[channel][numbers[channel].size() / 2];
    }
    return middle;
}

struct WedgeStep {
    double radiance = 0, number = 0; ///< as it should be, linear; as the picture has it, 0 to 1
};

void readCurve(const std::vector<WedgeStep>& wedge, Calibration& found) {
    // Eight bits leave a third of a level, dithering one; curves that differ do so by more than four in the dark steps.
    constexpr double kMostLevels = 3;
    constexpr double kClipped = 0.995;
    double best = 1e300;
    for (const ToneCurve curve : kToneCurves) {
        double products = 0, squares = 0;
        for (const WedgeStep& step : wedge)
            if (step.number < kClipped) {
                products += step.radiance * linearFrom(curve, step.number);
                squares += step.radiance * step.radiance;
            }
        const double brighter = squares > 0 ? products / squares : 1;
        // A picture whose last step alone is white is not brighter: eight bits would not tell.
        const double exposure = std::abs(brighter - 1) < 0.02 ? 1 : brighter;
        double sum = 0;
        for (const WedgeStep& step : wedge)
            sum += std::pow(255 * (encodedWith(curve, exposure * step.radiance) - step.number), 2);
        const double levels = std::sqrt(sum / static_cast<double>(wedge.size()));
        if (levels >= best) continue;
        best = levels;
        found.curve = curve;
        found.exposure = exposure;
    }
    found.curveError = best;
    if (best > kMostLevels) found.curve.reset();
}

} // namespace

image::Image putUpright(const image::Image& picture, const Orientation& orientation) {
    if (orientation == Orientation{}) return picture;
    image::Image upright(orientation.swapsAxes ? picture.height : picture.width,
                         orientation.swapsAxes ? picture.width : picture.height);
    for (int y = 0; y < upright.height; ++y)
        for (int x = 0; x < upright.width; ++x) {
            ivec2 at = orientation.swapsAxes ? ivec2(y, x) : ivec2(x, y);
            if (orientation.mirrorsX) at.x = picture.width - 1 - at.x;
            if (orientation.mirrorsY) at.y = picture.height - 1 - at.y;
            upright.set(x, y, picture.at(at.x, at.y));
        }
    return upright;
}

Calibration readCalibration(const image::Image& picture, const scene::Camera& camera, ivec2 size) {
    const BoardLayout board = boardLayout(size);
    Calibration found;
    const auto add = [&](FoundFault fault) { found.faults.push_back(std::move(fault)); };
    if (picture.width != size.x || picture.height != size.y) {
        add(sizeFault({picture.width, picture.height}, size));
        return found;
    }
    const BoardMatch match = searchBoard(picture, board, size);
    found.likeness = match.likeness;
    found.orientation = match.orientation;
    found.scale = match.scale;
    // Noise, or another scene, correlates by chance with less than a half of this; another curve and scale leave more.
    constexpr double kLeastLikeness = 0.7;
    if (match.likeness < kLeastLikeness) {
        add(strangerFault(match.likeness));
        return found;
    }
    const image::Image upright = putUpright(picture, match.orientation);
    Placement placed{0.5 * dvec2(size), {match.scale.x, 0.0}, {0.0, match.scale.y}};
    const double least = std::min(size.x, size.y);
    // First with room for what the search leaves open, then with a pixel or two for antialiasing.
    std::vector<SeenSquare> seen;
    for (const double margin : {std::max(0.04 * least, 2.0), 2.0}) {
        seen = squaresSeen(upright, board, size, placed, margin);
        placed = fitted(seen, placed);
    }
    if (seen.size() >= 2) {
        found.shiftPx = placed.centrePx - 0.5 * dvec2(size);
        found.scale = {glm::length(placed.perX), glm::length(placed.perY)};
        found.turnDegrees = glm::degrees(std::atan2(0.5 * (placed.perY.x - placed.perX.y), 0.5 * (placed.perX.x + placed.perY.y)));
    }
    std::vector<WedgeStep> wedge;
    for (std::size_t i = 0; i < board.wedge.size(); ++i)
        if (const auto number = numberOf(upright, board.wedge[i], size, placed))
            wedge.push_back({kWedge[i], (number->x + number->y + number->z) / 3});
    readCurve(wedge, found);
    std::array<dvec3, 3> channels{};
    for (std::size_t i = 0; i < channels.size(); ++i)
        channels[i] = numberOf(upright, board.channels[i], size, placed).value_or(dvec3(0.0));

    // In the order in which they are to be mended: a shift is measured rightly only in a picture of the right scale.
    if (found.orientation != Orientation{}) add(orientationFault(found.orientation));
    if (const auto fault = viewFault(found, camera, size)) add(*fault);
    if (const auto fault = turnFault(found, placed.perX, placed.perY, size)) add(*fault);
    if (const auto fault = shiftFault(found)) add(*fault);
    if (const auto fault = encodingFault(found)) add(*fault);
    if (const auto fault = channelFault(channels)) add(*fault);
    return found;
}

} // namespace shadowlab::foreign
