// SPDX-License-Identifier: MIT
#include "app/judge/coverage.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

#include "app/judge/truth_tiles.h"
#include "techniques/foundation/math/radical_inverse.h"
#include "techniques/foundation/trace/area/area_visibility.h"

namespace shadowlab::judge {

namespace {

using trace::SurfacePoint;
using trace::Visibility;

/// What one point of a pixel shows.
struct PointAnswer {
    std::uint32_t object = trace::kNoPrimitive;
    Visibility visibility = Visibility::noSurface;
    float share = 0; ///< of the light that is seen
};

bool facesTheLight(Visibility visibility) {
    return visibility == Visibility::lit || visibility == Visibility::shadowed;
}

PixelKind kindOf(std::span<const PointAnswer> answers) {
    const auto faces = [](const PointAnswer& answer) { return facesTheLight(answer.visibility); };
    if (std::ranges::none_of(answers, faces)) return PixelKind::none;
    const PointAnswer& first = answers.front();
    const auto isAlone = [&](const PointAnswer& answer) { return faces(answer) && answer.object == first.object; };
    if (!std::ranges::all_of(answers, isAlone)) return PixelKind::outline;
    const auto sees = [&](const PointAnswer& answer) { return answer.visibility == first.visibility; };
    return std::ranges::all_of(answers, sees) ? PixelKind::whole : PixelKind::edge;
}

float meanShare(std::span<const PointAnswer> answers) {
    double sum = 0;
    int facing = 0;
    for (const PointAnswer& answer : answers)
        if (facesTheLight(answer.visibility)) sum += static_cast<double>(answer.share), ++facing;
    return facing > 0 ? static_cast<float>(sum / facing) : 0.0f;
}

/// Asks all points of the pixels of a tile.
class PointsAsking {
public:
    PointsAsking(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size, int light, int points,
                 TruthOf of)
        : tracer_(tracer), rays_(tracer.eyeRays(camera, size)), light_(light), within_(subpixelPoints(points)) {
        if (of == TruthOf::area) area_.emplace(tracer, light);
    }

    /// One row of answers for each pixel of the tile.
    [[nodiscard]] std::vector<PointAnswer> ask(const Tile& tile) const {
        const std::size_t count = within_.size();
        std::vector<SurfacePoint> points(count * tile.count());
        std::vector<PointAnswer> answers(points.size());
        TilePoints seen;
        TileVisibility visibility;
        for (std::size_t k = 0; k < count; ++k) {
            const std::span<SurfacePoint> ofTile = std::span(seen).first(tile.count());
            tracer_.eyePoints(rays_, tile.corner, tile.size, within_[k], ofTile);
            if (!area_) tracer_.visibilities(ofTile, light_, std::span(visibility).first(tile.count()));
            for (std::size_t i = 0; i < tile.count(); ++i) {
                points[i * count + k] = seen[i];
                PointAnswer& answer = answers[i * count + k];
                answer.object = objectOf(tracer_, seen[i]);
                if (area_) continue;
                answer.visibility = visibility[i];
                answer.share = visibility[i] == Visibility::lit ? 1.0f : 0.0f;
            }
        }
        if (area_) askArea(points, answers);
        return answers;
    }

private:
    /// The shares of a light's area, of all points of the tile at once, which is quicker.
    void askArea(std::span<const SurfacePoint> points, std::span<PointAnswer> answers) const {
        std::vector<trace::AreaShare> shares(points.size());
        area_->shares(points, {}, shares);
        for (std::size_t i = 0; i < points.size(); ++i) {
            answers[i].share = static_cast<float>(shares[i].visible);
            answers[i].visibility = visibilityOf(tracer_, light_, points[i], static_cast<double>(answers[i].share));
        }
    }

    const trace::SceneTracer& tracer_;
    trace::EyeRays rays_;
    int light_;
    std::vector<dvec2> within_;
    std::optional<trace::AreaVisibility> area_; ///< none: the light's centre is asked for
};

std::size_t pixelsOf(ivec2 size) { return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y); }

} // namespace

std::vector<dvec2> subpixelPoints(int count) {
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [](int i) { return radicalInverse(i, 2); });
    std::vector<dvec2> points(order.size());
    for (std::size_t rank = 0; rank < order.size(); ++rank)
        points[static_cast<std::size_t>(order[rank])] =
            (dvec2(order[rank], static_cast<double>(rank)) + 0.5) / static_cast<double>(count);
    return points;
}

Coverage trueCoverage(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size, int light, int points,
                      TruthOf of, const std::stop_token& stop) {
    Coverage coverage{size, points, std::vector<float>(pixelsOf(size), 0.0f),
                      std::vector(pixelsOf(size), PixelKind::none)};
    const PointsAsking asking(tracer, camera, size, light, points, of);
    forEachTile(size, stop, [&](const Tile& tile) {
        const std::vector<PointAnswer> answers = asking.ask(tile);
        forEachPixel(tile, size, [&](std::size_t i, std::size_t inTile, ivec2) {
            const auto count = static_cast<std::size_t>(points);
            const auto own = std::span(answers).subspan(inTile * count, count);
            coverage.shares[i] = meanShare(own);
            coverage.kinds[i] = kindOf(own);
        });
    });
    return coverage;
}

std::vector<std::uint8_t> facingCentres(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size,
                                        int light) {
    std::vector<std::uint8_t> facing(pixelsOf(size), 0);
    const trace::EyeRays rays = tracer.eyeRays(camera, size);
    forEachTile(size, {}, [&](const Tile& tile) {
        TilePoints points;
        tracer.eyePoints(rays, tile.corner, tile.size, dvec2(0.5), std::span(points).first(tile.count()));
        forEachPixel(tile, size, [&](std::size_t i, std::size_t inTile, ivec2) {
            facing[i] = points[inTile] && tracer.facesLight(points[inTile], light) ? 1 : 0;
        });
    });
    return facing;
}

} // namespace shadowlab::judge
