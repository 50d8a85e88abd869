// SPDX-License-Identifier: MIT
#include "app/judge/truth.h"

#include <algorithm>
#include <cmath>

#include "app/judge/area_truth.h"
#include "app/judge/truth_tiles.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::judge {

namespace {

using trace::SurfacePoint;
using trace::Visibility;

struct Answers {
    TilePoints points;
    TileVisibility visibility;
};

class Asking {
public:
    Asking(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size, int light)
        : tracer_(tracer), rays_(tracer.eyeRays(camera, size)), light_(light) {}

    /// What is seen through one point of each pixel, and whether the light reaches it.
    void ask(const Tile& tile, dvec2 within, Answers& answers) const {
        tracer_.eyePoints(rays_, tile.corner, tile.size, within, std::span(answers.points).first(tile.count()));
        tracer_.visibilities(std::span(answers.points).first(tile.count()), light_,
                             std::span(answers.visibility).first(tile.count()));
    }

    /// The answer if a pixel showed this triangle. Nothing where the triangle has a hole: if its border were near enough for
    /// rounding, points around the centre would have seen so.
    [[nodiscard]] std::optional<Visibility> ofPrimitive(std::uint32_t primitive, dvec2 pixel) const {
        if (primitive == trace::kNoPrimitive) return Visibility::noSurface;
        const std::optional<SurfacePoint> shown = pointOfPrimitive(tracer_, rays_, primitive, pixel);
        if (!shown) return Visibility::turnedAway;
        if (tracer_.isInHole(*shown)) return std::nullopt;
        return tracer_.visibility(*shown, light_);
    }

    [[nodiscard]] std::uint32_t objectOf(const SurfacePoint& point) const { return judge::objectOf(tracer_, point); }

private:
    const trace::SceneTracer& tracer_;
    trace::EyeRays rays_;
    int light_;
};

/// Traces the pixels' centres and then, tile by tile, calls `more`.
Truth askCentres(const Asking& asking, ivec2 size, const std::stop_token& stop,
                 const std::function<void(const Tile&, const Answers&, Truth&)>& more) {
    Truth truth = emptyTruth(size);
    forEachTile(size, stop, [&](const Tile& tile) {
        Answers centres;
        asking.ask(tile, dvec2(0.5), centres);
        forEachPixel(tile, size, [&](std::size_t i, std::size_t inTile, ivec2) {
            truth.visibility[i] = centres.visibility[inTile];
            truth.objects[i] = asking.objectOf(centres.points[inTile]);
        });
        more(tile, centres, truth);
    });
    return truth;
}

} // namespace

double tieRadius(int subpixelBits) { return std::max(1.0 / 64.0, 2.0 * std::ldexp(1.0, -subpixelBits)); }

Truth truthAtCentres(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size, int light,
                     const std::stop_token& stop, TruthOf of) {
    if (of == TruthOf::area) return areaTruth(tracer, camera, size, light, nullptr, stop);
    return askCentres(Asking(tracer, camera, size, light), size, stop, [](const Tile&, const Answers&, Truth&) {});
}

std::vector<std::uint8_t> tiesAmong(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size,
                                    int light, double tieRadiusPx, const std::vector<ivec2>& pixels, TruthOf of) {
    if (of == TruthOf::area) return areaTiesAmong(tracer, camera, size, light, tieRadiusPx, pixels);
    const Asking asking(tracer, camera, size, light);
    std::vector<std::uint8_t> ties(pixels.size(), 0);
    trace::parallelFor(pixels.size(), [&](std::size_t i) {
        const Tile tile{pixels[i], ivec2(1)};
        Answers centre, around;
        asking.ask(tile, dvec2(0.5), centre);
        for (int step = 0; step < kPointsAround && !ties[i]; ++step) {
            asking.ask(tile, pointAround(step, tieRadiusPx), around);
            ties[i] = around.visibility[0] != centre.visibility[0];
        }
    });
    return ties;
}

Truth exactTruth(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size, int light,
                 const Rasterised& rasterised, const std::stop_token& stop, TruthOf of) {
    if (of == TruthOf::area) return areaTruth(tracer, camera, size, light, &rasterised, stop);
    const Asking asking(tracer, camera, size, light);
    return askCentres(asking, size, stop, [&](const Tile& tile, const Answers& centres, Truth& truth) {
        Answers around;
        for (int step = 0; step < kPointsAround; ++step) {
            asking.ask(tile, pointAround(step, rasterised.tieRadiusPx), around);
            forEachPixel(tile, size, [&](std::size_t i, std::size_t inTile, ivec2) {
                if (around.visibility[inTile] != centres.visibility[inTile]) truth.ties[i] = 1;
            });
        }
        if (rasterised.primitives.empty()) return;
        forEachPixel(tile, size, [&](std::size_t i, std::size_t inTile, ivec2 pixel) {
            const std::uint32_t drawn = rasterised.primitives[i];
            if (drawn == centres.points[inTile].primitive) return;
            const std::optional<Visibility> other = asking.ofPrimitive(drawn, dvec2(pixel) + 0.5);
            if (other && *other != centres.visibility[inTile]) truth.ties[i] = 1;
        });
    });
}

} // namespace shadowlab::judge
