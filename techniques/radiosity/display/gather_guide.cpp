// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/gather_guide.h"

#include <algorithm>

#include <glm/gtc/constants.hpp>

#include "techniques/radiosity/patches/polygon_samples.h"

namespace shadowlab::radiosity {

namespace {

// What a ray in any direction brings has a variance. In units of the square of its mean, light is uneven above this. Half of the rays would find all of the
// light by choice, if patches were points: with variance 1 both kinds together are no better than one. Rays to chosen points also cost more, as many
// of them end before: at 1 the room with lamps took an eighth longer, and from 2 to 4 noise in a room with the sun on its floor grew by a twentieth.
constexpr double kUneven = 2;

// A patch that sees more than this share of its view outside stands under the open sky. The side of a box on a ground sees half of it.
constexpr double kOpenSky = 0.4;

/// That variance, for a patch of that area: `exchange` S_ij, `sent` the luminance of each radiosity, and `sky` that of what comes from where it sees no surface.
double relativeVariance(std::span<const double> exchange, double area, std::span<const double> sent, double sky, double shareOfSky) {
    double mean = shareOfSky * sky, meanSquare = shareOfSky * sky * sky;
    for (std::size_t j = 0; j < sent.size(); ++j) {
        mean += exchange[j] / area * sent[j];
        meanSquare += exchange[j] / area * sent[j] * sent[j];
    }
    return mean > 0 ? meanSquare / (mean * mean) - 1 : 0;
}

} // namespace

GatherGuide::GatherGuide(const Room& room, const ExchangeMatrix& exchange, std::span<const dvec3> radiosity, std::span<const dvec3> emission, const dvec3& outside)
    : room_(&room), upTo_(exchange.size()) {
    std::vector<double> sent(exchange.size()), emitted(exchange.size());
    std::vector<std::uint8_t> isSimplified(exchange.size());
    for (std::size_t j = 0; j < sent.size(); ++j) {
        isSimplified[j] = !room.simple().cornersOfObject[room.faceOf(room.allPatches()[j]).object].empty();
        sent[j] = luminance(radiosity[j]);
        emitted[j] = luminance(emission[j]);
    }
    const double sky = glm::pi<double>() * luminance(outside);
    forRows(upTo_.size(), [&](std::size_t i) {
        const bool isOpen = room.surroundings()[i] > kOpenSky;
        const std::span<const double> row = exchange.row(i), from = isOpen ? emitted : sent;
        if (relativeVariance(row, room.patches()[i].area, from, sky, room.surroundings()[i]) <= kUneven) return;
        std::vector<double> sums(row.size());
        double sum = 0;
        for (std::size_t j = 0; j < row.size(); ++j)
            sums[j] = sum += isSimplified[j] ? 0 : row[j] * from[j];
        if (!(sum > 0)) return;
        upTo_[i].resize(row.size());
        std::ranges::transform(sums, upTo_[i].begin(), [&](double one) { return static_cast<float>(one / sum); });
    });
}

double GatherGuide::share(std::uint32_t at, std::uint32_t other) const {
    return static_cast<double>(upTo_[at][other]) - (other > 0 ? static_cast<double>(upTo_[at][other - 1]) : 0);
}

GatherGuide::Choice GatherGuide::choose(std::uint32_t at, double which, const dvec2& where) const {
    const std::vector<float>& upTo = upTo_[at];
    const auto found = std::ranges::upper_bound(upTo, static_cast<float>(which)); // rounded to 1 it is the end: then the last that has a share
    const auto patch = static_cast<std::uint32_t>((found == upTo.end() ? std::ranges::lower_bound(upTo, upTo.back()) : found) - upTo.begin());
    const Patch& one = room_->patches()[patch];
    const Place place = placeIn(one.polygon, where.x, where.y);
    // Where the map to the polygon stretches the unit square, points are fewer.
    const double stretched = one.polygon.count() == 3 ? one.area : one.polygon.count() == 4 ? place.weight : 0.5 * place.weight;
    return {patch, room_->world().originWorld + place.point, one.normal, share(at, patch) / stretched};
}

double GatherGuide::density(std::uint32_t at, std::uint32_t other) const {
    return other < upTo_[at].size() ? share(at, other) / room_->patches()[other].area : 0;
}

} // namespace shadowlab::radiosity
