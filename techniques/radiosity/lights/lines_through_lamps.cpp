// SPDX-License-Identifier: MIT
#include "techniques/radiosity/lights/lines_through_lamps.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "techniques/foundation/math/radical_inverse.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/radiosity/display/aimed_rays.h"

namespace shadowlab::radiosity {

namespace {

// Of 600 patches, each sees some eight hundred of these lines: what lamps take of its light is right to some hundredths.
constexpr int kLinePieces = 64, kLinesInPiece = 4096, kLampLines = kLinePieces * kLinesInPiece;

} // namespace

LampLinesBuilder::LampLinesBuilder(const Room& room, const SurfaceCells& cells, scene::Snapshot drawn, std::vector<std::uint8_t> isInTheWay)
    : room_(room), cells_(cells), drawn_(std::move(drawn)), isInTheWay_(std::move(isInTheWay)), pieces_(kLinePieces) {}

bool LampLinesBuilder::advance(std::chrono::steady_clock::time_point deadline) {
    if (!tracer_.advance(drawn_, deadline)) return false;
    if (!isPrepared_) findSides();
    isPrepared_ = true;
    if (sides_.empty()) return true;
    nextPiece_ = trace::parallelUntil(deadline, nextPiece_, pieces_.size(), [&](std::size_t piece) { send(piece); });
    return nextPiece_ == pieces_.size();
}

/// A rect has two sides, a ball one.
void LampLinesBuilder::findSides() {
    double area = 0;
    for (std::uint32_t t = 0; t < tracer_.bvh().triangles.size(); ++t)
        for (const bool isFront : {true, false}) {
            const trace::SurfacePoint middle{t, isFront, dvec2(1.0 / 3)};
            const int light = tracer_.objectOf(middle).emitterOfLight;
            if (light < 0 || isInTheWay_[static_cast<std::size_t>(light)] == 0) continue;
            const bool isClosed = drawn_->light(light).type == scene::LightType::sphere;
            if (isClosed && !isFront) continue;
            area += 0.5 * glm::length(trace::frontOf(tracer_.bvh().triangles[t]));
            sides_.push_back({middle, isClosed, area});
        }
}

void LampLinesBuilder::send(std::size_t piece) {
    const auto patchAt = [&](const trace::SurfacePoint& point) {
        const std::optional<std::uint32_t> patch = point ? patchOf(point, cells_, tracer_) : std::nullopt;
        return patch && *patch < room_.patches().size() ? patch : std::nullopt;
    };
    for (int n = 0; n < kLinesInPiece; ++n) {
        const int line = static_cast<int>(piece) * kLinesInPiece + n;
        const Side& side = *std::ranges::upper_bound(sides_, (line + 0.5) / kLampLines * sides_.back().upTo, {}, &Side::upTo);
        const trace::SurfacePoint exit = placeOn(side.middle, {radicalInverse(line, 2), radicalInverse(line, 3)});
        const dvec3 direction = diffuseDirection(tracer_, exit, {radicalInverse(line, 5), radicalInverse(line, 7)});
        // This lamp is the last on its line; another will have those that go on through it.
        const auto to = patchAt(tracer_.nextPoint(exit, direction));
        if (!to) continue;
        bool isInside = side.isClosed;
        trace::SurfacePoint back = tracer_.nextPoint(exit, -direction);
        for (; back && tracer_.objectOf(back).emitterOfLight >= 0; back = tracer_.nextPoint(back, -direction))
            if (drawn_->light(tracer_.objectOf(back).emitterOfLight).type == scene::LightType::sphere) isInside = back.eyeOnFront;
        const auto from = patchAt(back);
        // On a surface that cuts the lamp, what lies within it sends nothing in the first place (lamp_cover.h).
        if (from && from != to && !isInside) pieces_[piece].push_back(std::minmax(*from, *to));
    }
}

std::vector<ExchangeArea> LampLinesBuilder::take() {
    std::vector<Pair> all;
    for (const std::vector<Pair>& piece : pieces_)
        all.insert(all.end(), piece.begin(), piece.end());
    std::ranges::sort(all);
    std::vector<ExchangeArea> taken;
    for (const auto& [i, j] : all) {
        if (taken.empty() || taken.back().i != i || taken.back().j != j) taken.push_back({i, j, 0});
        taken.back().area += 0.5 * sides_.back().upTo / kLampLines; // half, as a line is found from both of its ends
    }
    return taken;
}

std::vector<ExchangeArea> takeOut(ExchangeMatrix& matrix, std::span<const ExchangeArea> taken) {
    std::vector<ExchangeArea> before;
    double left = 0; // m^2
    for (const auto& [i, j, area] : taken) {
        const double there = matrix(i, j), wanted = left + area, part = std::min(wanted, there);
        left = wanted - part;
        before.push_back({i, j, there});
        matrix.set(i, j, there - part);
    }
    return before;
}

void putBack(ExchangeMatrix& matrix, std::span<const ExchangeArea> before) {
    for (const auto& [i, j, area] : before)
        matrix.set(i, j, area);
}

} // namespace shadowlab::radiosity
