// SPDX-License-Identifier: MIT
#include "app/picture/stages/shadow_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/judge/grid.h"
#include "app/judge/verdict.h"
#include "app/picture/outside/shape_painter.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::picture {

namespace {

using judge::Grid;
using judge::OutlineSegment;

// Narrower than other lines: they are looked at, this one is looked past, at the shadow's edge on either side of it.
constexpr float kNarrower = 2.0f / 3;
constexpr float kRimWidth = 2; ///< of the line's own: one pixel on each side of two

double squaredDistance(const dvec2& point, const OutlineSegment& segment) {
    const dvec2 along = segment.to - segment.from, offset = point - segment.from;
    const double squaredLength = glm::dot(along, along);
    const double share = squaredLength > 0 ? std::clamp(glm::dot(offset, along) / squaredLength, 0.0, 1.0) : 0.0;
    const dvec2 away = offset - share * along;
    return glm::dot(away, away);
}

/// From each pixel's centre to the nearest segment, squared; infinite where it is farther than `reach` pixels, and outside
/// the region. One distance for all segments, so that no joint is painted twice.
Grid<double> squaredDistances(const std::vector<OutlineSegment>& outline, ivec2 size, const Region& shown,
                              double reach) {
    Grid<double> squared(size.x, size.y, std::numeric_limits<double>::infinity());
    for (const OutlineSegment& segment : outline) {
        const ivec2 low = glm::max(ivec2(glm::floor(glm::min(segment.from, segment.to) - reach)), shown.corner);
        const ivec2 high =
            glm::min(ivec2(glm::ceil(glm::max(segment.from, segment.to) + reach)), shown.corner + shown.size);
        for (int y = low.y; y < high.y; ++y)
            for (int x = low.x; x < high.x; ++x)
                squared.at(x, y) = std::min(squared.at(x, y), squaredDistance(dvec2(x, y) + 0.5, segment));
    }
    return squared;
}

/// Length of the segments in the region, in pixels.
double shownLength(const std::vector<OutlineSegment>& outline, const Region& shown) {
    std::vector<OutlineSegment> within;
    std::ranges::copy_if(outline, std::back_inserter(within), [&](const OutlineSegment& segment) {
        const ivec2 pixel(glm::floor(0.5 * (segment.from + segment.to)));
        const ivec2 end = shown.corner + shown.size;
        return glm::all(glm::greaterThanEqual(pixel, shown.corner)) && glm::all(glm::lessThan(pixel, end));
    });
    return judge::lengthPx(within);
}

} // namespace

Panel shadowOutlinePanel(image::Image picture, const std::vector<OutlineSegment>& outline, const std::string& light,
                         const Region& region) {
    const ivec2 size(picture.width, picture.height);
    const Region shown = judge::shownPart(region, size);
    const float half = 0.5f * kNarrower * lineWidth(size.y), halfRim = kRimWidth * half;
    const Grid<double> squared = squaredDistances(outline, size, shown, halfRim + 0.5);
    const image::Color8 core = image::encoded(look::kTrueOutline), rim = image::encoded(look::kLineRim);
    for (int y = shown.corner.y; y < shown.corner.y + shown.size.y; ++y)
        for (int x = shown.corner.x; x < shown.corner.x + shown.size.x; ++x) {
            if (std::isinf(squared.at(x, y))) continue;
            const auto distance = static_cast<float>(std::sqrt(squared.at(x, y)));
            const auto coverage = [&](float halfWidth) { return std::clamp(halfWidth + 0.5f - distance, 0.0f, 1.0f); };
            blendPixel(picture, x, y, rim, look::kLineRimAlpha * coverage(halfRim));
            blendPixel(picture, x, y, core, coverage(half));
        }
    Panel panel{std::move(picture), "", StageKind::swatches, {}};
    const double length = shownLength(outline, shown);
    panel.display.key = {{look::kTrueOutline, length > 0 ? "where the shadow of '" + light + "' really ends: " +
                                                               std::to_string(std::lround(length)) + " px long"
                                                         : "no shadow of '" + light + "' ends here"}};
    return panel;
}

} // namespace shadowlab::picture
