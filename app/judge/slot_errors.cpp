// SPDX-License-Identifier: MIT
#include "app/judge/slot_errors.h"

#include <algorithm>

namespace shadowlab::judge {

namespace {

using trace::Visibility;

Shade shadeOf(Visibility visibility) {
    switch (visibility) {
    case Visibility::noSurface: return Shade::outside;
    case Visibility::turnedAway: return Shade::turnedAway;
    case Visibility::shadowed: return Shade::shadowed;
    case Visibility::lit: return Shade::lit;
    }
    return Shade::outside;
}

Grid<Shade> shadesOf(const Truth& truth) {
    Grid<Shade> shades(truth.size.x, truth.size.y);
    std::ranges::transform(truth.visibility, shades.values.begin(), shadeOf);
    return shades;
}

Grid<std::uint32_t> receiversOf(const Truth& truth) {
    Grid<std::uint32_t> receivers(truth.size.x, truth.size.y);
    receivers.values = truth.objects;
    return receivers;
}

/// The technique's answers where they are compared; elsewhere the truth's.
Grid<Shade> shadesOf(std::span<const std::uint8_t> greyAlpha, const Truth& truth) {
    Grid<Shade> shades(truth.size.x, truth.size.y);
    for (std::size_t i = 0; i < shades.values.size(); ++i) {
        const bool covered = greyAlpha[2 * i + 1] == 255, lit = greyAlpha[2 * i] > 127;
        const Shade exact = shadeOf(truth.visibility[i]);
        const bool compared = (exact == Shade::lit || exact == Shade::shadowed) && truth.ties[i] == 0;
        shades.values[i] = !compared ? exact : !covered ? Shade::outside : lit ? Shade::lit : Shade::shadowed;
    }
    return shades;
}

} // namespace

std::vector<BoundaryEdge> trueBoundary(const Truth& truth) {
    return boundaryEdges(shadesOf(truth), receiversOf(truth));
}

double lengthPx(const std::vector<BoundaryEdge>& edges, const Region& region, ivec2 size) {
    const auto [corner, extent] = shownPart(region, size);
    std::vector<BoundaryEdge> within;
    std::ranges::copy_if(edges, std::back_inserter(within), [&, corner = corner, end = corner + extent](ivec2 edge) {
        const ivec2 pixel = edge / 2; // on its right, or below it
        return pixel.x >= corner.x && pixel.x < end.x && pixel.y >= corner.y && pixel.y < end.y;
    });
    return lengthPx(within);
}

SlotErrors slotErrors(const Truth& truth, const std::vector<BoundaryEdge>& boundary,
                      std::span<const std::uint8_t> greyAlpha, const Region& region) {
    SlotErrors errors{judge(truth, greyAlpha, region), std::nullopt};
    const double length = lengthPx(boundary, region, truth.size);
    if (length > 0) errors.edgeErrorPx = errors.judgement.counts.wrong() / length;
    return errors;
}

int coreErrors(const Truth& truth, const Judgement& judgement, const Grid<float>& distancePx,
               const std::optional<Grid<float>>& texelPx) {
    Grid<std::uint8_t> wrong(truth.size.x, truth.size.y);
    std::ranges::transform(judgement.verdicts, wrong.values.begin(), [](Verdict verdict) {
        return verdict == Verdict::falseLit || verdict == Verdict::falseShadow ? 1 : 0;
    });
    return coreErrors(wrong, distancePx, texelPx);
}

std::optional<Displacement> displacement(const Truth& truth, const std::vector<BoundaryEdge>& boundary,
                                         std::span<const std::uint8_t> greyAlpha) {
    return displacement(boundary, boundaryEdges(shadesOf(greyAlpha, truth), receiversOf(truth)), truth.size);
}

} // namespace shadowlab::judge
