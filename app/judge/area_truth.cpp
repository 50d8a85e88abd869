// SPDX-License-Identifier: MIT
#include "app/judge/area_truth.h"

#include <algorithm>
#include <cmath>

#include "app/judge/truth_tiles.h"
#include "techniques/foundation/trace/area/area_visibility.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::judge {

namespace {

using trace::AreaShare;
using trace::SurfacePoint;
using trace::Visibility;

class AreaAsking {
public:
    AreaAsking(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size, int light)
        : tracer_(tracer), area_(tracer, light), rays_(tracer.eyeRays(camera, size)), light_(light) {}

    void eyePoints(const Tile& tile, dvec2 within, TilePoints& points) const {
        tracer_.eyePoints(rays_, tile.corner, tile.size, within, std::span(points).first(tile.count()));
    }

    [[nodiscard]] Visibility visibility(const SurfacePoint& point, double share) const {
        return visibilityOf(tracer_, light_, point, share);
    }

    /// The same where the pixel shows that triangle.
    [[nodiscard]] std::optional<Visibility> ofPrimitive(std::uint32_t primitive, dvec2 pixel) const {
        if (primitive == trace::kNoPrimitive) return Visibility::noSurface;
        const std::optional<SurfacePoint> shown = pointOfPrimitive(tracer_, rays_, primitive, pixel);
        if (!shown) return Visibility::turnedAway;
        if (tracer_.isInHole(*shown)) return std::nullopt;
        return visibility(*shown, area_.share(*shown));
    }

    /// The centres of a tile: where they are, what they see, and whether anything else is seen around them.
    struct Answers {
        TilePoints points;
        std::array<AreaShare, kTilePixels> shares;
        TileVisibility visibility;
        std::array<std::uint8_t, kTilePixels> ties;
    };
    /// Without a radius no ties are looked for.
    void ask(const Tile& tile, double tieRadiusPx, Answers& answers) const {
        eyePoints(tile, dvec2(0.5), answers.points);
        answers.ties.fill(0);
        std::vector<TilePoints> around(tieRadiusPx > 0 ? kPointsAround : 0);
        std::array<double, kTilePixels> moves{};
        for (std::size_t step = 0; step < around.size(); ++step) {
            eyePoints(tile, pointAround(static_cast<int>(step), tieRadiusPx), around[step]);
            for (std::size_t i = 0; i < tile.count(); ++i)
                if (onOneTriangle(answers.points[i], around[step][i]))
                    moves[i] = std::max(moves[i], glm::length(tracer_.positionCentred(around[step][i]) -
                                                              tracer_.positionCentred(answers.points[i])));
        }
        area_.shares(std::span(answers.points).first(tile.count()), std::span(moves).first(tile.count()),
                     std::span(answers.shares).first(tile.count()));
        for (std::size_t i = 0; i < tile.count(); ++i)
            answers.visibility[i] = visibility(answers.points[i], answers.shares[i].visible);
        findTies(tile, around, answers);
    }

private:
    /// Background, or shut: whatever stands between.
    static bool isGate(Visibility visibility) {
        return visibility == Visibility::noSurface || visibility == Visibility::turnedAway;
    }
    static bool onOneTriangle(const SurfacePoint& a, const SurfacePoint& b) { return a && a.primitive == b.primitive; }

    void findTies(const Tile& tile, const std::vector<TilePoints>& around, Answers& answers) const {
        std::vector<SurfacePoint> open;
        std::vector<std::size_t> pixelOf;
        for (std::size_t i = 0; i < tile.count(); ++i) {
            const std::size_t before = open.size();
            // Then the share passes one half nowhere around.
            const bool certain = std::abs(answers.shares[i].visible - 0.5) > answers.shares[i].change;
            for (const TilePoints& points : around) {
                const SurfacePoint& point = points[i];
                const Visibility ofNothing = visibility(point, 0); // what it is unless some of the light is seen
                if (isGate(ofNothing) || isGate(answers.visibility[i])) {
                    if (ofNothing != answers.visibility[i]) answers.ties[i] = 1;
                } else if (!certain || !onOneTriangle(answers.points[i], point)) {
                    open.push_back(point);
                }
            }
            if (answers.ties[i]) open.resize(before); // known already
            pixelOf.resize(open.size(), i);
        }
        std::vector<AreaShare> shares(open.size());
        area_.shares(open, {}, shares);
        for (std::size_t k = 0; k < open.size(); ++k)
            if (visibility(open[k], shares[k].visible) != answers.visibility[pixelOf[k]]) answers.ties[pixelOf[k]] = 1;
    }

    const trace::SceneTracer& tracer_;
    trace::AreaVisibility area_;
    trace::EyeRays rays_;
    int light_;
};

} // namespace

Truth areaTruth(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size, int light,
                const Rasterised* rasterised, const std::stop_token& stop) {
    const AreaAsking asking(tracer, camera, size, light);
    Truth truth = emptyTruth(size);
    truth.shares.resize(truth.visibility.size());
    forEachTile(size, stop, [&](const Tile& tile) {
        AreaAsking::Answers answers;
        asking.ask(tile, rasterised ? rasterised->tieRadiusPx : 0.0, answers);
        forEachPixel(tile, size, [&](std::size_t i, std::size_t inTile, ivec2 pixel) {
            truth.visibility[i] = answers.visibility[inTile];
            truth.shares[i] = static_cast<float>(answers.shares[inTile].visible);
            truth.objects[i] = objectOf(tracer, answers.points[inTile]);
            truth.ties[i] = answers.ties[inTile];
            if (!rasterised || rasterised->primitives.empty() || truth.ties[i]) return;
            const std::uint32_t drawn = rasterised->primitives[i];
            if (drawn == answers.points[inTile].primitive) return;
            const std::optional<Visibility> other = asking.ofPrimitive(drawn, dvec2(pixel) + 0.5);
            if (other && *other != answers.visibility[inTile]) truth.ties[i] = 1;
        });
    });
    return truth;
}

std::vector<std::uint8_t> areaTiesAmong(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size,
                                        int light, double tieRadiusPx, const std::vector<ivec2>& pixels) {
    const AreaAsking asking(tracer, camera, size, light);
    std::vector<std::uint8_t> ties(pixels.size(), 0);
    trace::parallelFor(pixels.size(), [&](std::size_t i) {
        AreaAsking::Answers answers;
        asking.ask({pixels[i], ivec2(1)}, tieRadiusPx, answers);
        ties[i] = answers.ties[0];
    });
    return ties;
}

} // namespace shadowlab::judge
