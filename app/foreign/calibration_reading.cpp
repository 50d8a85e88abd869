// SPDX-License-Identifier: MIT
#include "app/foreign/calibration_reading.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/foreign/board_search.h"
#include "app/foreign/calibration_words.h"
#include "app/foreign/camera_code.h"
#include "app/foreign/camera_fit.h"
#include "app/foreign/seen_squares.h"

namespace shadowlab::foreign {

namespace {

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

/// The code that the cells show; nothing where of any bit neither cell is much brighter than the other, or one lies outside.
std::optional<std::uint16_t> codeOf(const image::Image& picture, const BoardLayout& board, ivec2 size, const Placement& placed) {
    unsigned code = 0;
    for (std::size_t bit = 0; bit < board.code.size(); ++bit) {
        double bright[2];
        for (std::size_t row = 0; row < 2; ++row) {
            const dvec2 centre = placed(board.code[bit][row].centrePx - 0.5 * dvec2(size));
            if (centre.x < 0 || centre.y < 0 || centre.x >= size.x || centre.y >= size.y) return std::nullopt;
            const auto number = numberOf(picture, board.code[bit][row], size, placed);
            if (!number) return std::nullopt;
            bright[row] = (number->x + number->y + number->z) / 3;
        }
        constexpr double kPlainly = 0.25; // white is at least a half, whatever the curve, and grey backgrounds are dark
        if (std::abs(bright[0] - bright[1]) < kPlainly) return std::nullopt;
        if (bright[0] > bright[1]) code |= 1u << bit;
    }
    return static_cast<std::uint16_t>(code);
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
    Placement placed{(0.5 + match.shift) * dvec2(size), {match.scale.x, 0.0}, {0.0, match.scale.y}};
    const double least = std::min(size.x, size.y);
    // First with room for what the search leaves open, then with a pixel or two for antialiasing.
    std::vector<SeenSquare> seen;
    std::optional<Placement> measured;
    for (const double margin : {std::max(0.04 * least, 2.0), 2.0}) {
        seen = wholeSquares(upright, board, size, placed, margin);
        measured = fitted(bestOf(seen), size);
        placed = measured.value_or(placed);
    }
    found.wholeSquares = static_cast<int>(seen.size());
    if (measured) {
        found.shiftPx = placed.centrePx - 0.5 * dvec2(size);
        found.scale = {glm::length(placed.perX), glm::length(placed.perY)};
        found.turnDegrees = glm::degrees(std::atan2(0.5 * (placed.perY.x - placed.perX.y), 0.5 * (placed.perX.x + placed.perY.y)));
    }
    if (measured && !isPlane(seen, placed, size)) found.camera = fittedCamera(seen, board, camera, size);
    found.code = codeOf(upright, board, size, placed);
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
    const std::uint16_t code = cameraCode(camera, size);
    if (found.code && *found.code != code) {
        // What is seen of another board says nothing of the camera that saw it.
        add(otherBoardFault(*found.code, code));
    } else if (!measured) {
        add(cutFault(found.wholeSquares, static_cast<int>(board.squares.size())));
    } else if (const auto fault = cameraFault(found.camera, worstMissPx(seen, placed), camera, size)) {
        add(*fault);
    } else {
        if (const auto fault = viewFault(found, camera, size)) add(*fault);
        if (const auto fault = turnFault(found, placed.perX, placed.perY, size)) add(*fault);
        if (const auto fault = shiftFault(found)) add(*fault);
        // Where all is in its place the cells are, too.
        if (!found.code && found.faults.empty()) add(noCodeFault());
    }
    if (const auto fault = encodingFault(found)) add(*fault);
    if (const auto fault = channelFault(channels)) add(*fault);
    return found;
}

} // namespace shadowlab::foreign
