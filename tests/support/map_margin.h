// By how much a comparison of a shadow map is decided, and so whether rounding may decide it otherwise on a graphics card.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/probed/map_probe.h"
#include "tests/support/edge_texels.h"

namespace shadowlab::testing {

/// What may come out of the filter, where each comparison that rounding can turn over is either.
struct PossibleAnswer {
    double low = 0, high = 0;
    int atBorder = 0, atDepth = 0, atEdge = 0; ///< comparisons in doubt: for which of the reasons
    [[nodiscard]] bool isCertain() const { return atBorder + atDepth + atEdge == 0; }
};

/// A tap is in doubt
///  - where its place is nearer to a texel's border than kPlaceTexels: float positions are off by 2^-21 of their distance, a few
///    ten-thousandths of a texel of a small map, and a sample's angle of up to 40 turns by as much again;
///  - where the two depths differ by less than kUnits steps of 24 bits and kShareOfBias of the bias: the same 2^-21 are 16
///    steps where depth changes most with distance, and derivatives between neighbouring pixels, that the bias is made of, have
///    lost three digits;
///  - where an edge passes the texel's centre within the rasteriser's 1/256.
class MapMargin {
public:
    static constexpr double kPlaceTexels = 1e-3, kUnits = 64, kShareOfBias = 2e-3, kUnit = 1.0 / 16777215;

    MapMargin(const MapProbe& map, const EdgeTexels& edges) : map_(map), edges_(edges) {}

    [[nodiscard]] PossibleAnswer of(const std::vector<MapProbe::Tap>& taps) const {
        PossibleAnswer answer;
        for (const MapProbe::Tap& tap : taps) {
            const dvec2 within = tap.placeTexels - glm::floor(tap.placeTexels);
            const dvec2 toBorder = glm::min(within, 1.0 - within);
            const bool atBorder = std::min(toBorder.x, toBorder.y) < kPlaceTexels;
            const double bias = std::abs(tap.compared - map_.str.z);
            const bool atDepth = std::abs(tap.compared - tap.stored) < kUnits * kUnit + kShareOfBias * bias;
            const bool atEdge = edges_(tap.texel);
            answer.atBorder += atBorder;
            answer.atDepth += !atBorder && atDepth;
            answer.atEdge += !atBorder && !atDepth && atEdge;
            const bool inDoubt = atBorder || atDepth || atEdge;
            answer.low += !inDoubt && tap.isLit ? tap.weight : 0;
            answer.high += inDoubt || tap.isLit ? tap.weight : 0;
        }
        return answer;
    }

private:
    const MapProbe& map_;
    const EdgeTexels& edges_;
};

} // namespace shadowlab::testing
