// SPDX-License-Identifier: MIT
#include "app/measure/truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/trace/parallel.h"
#include "techniques/foundation/trace/ray_triangle.h"

namespace shadowlab::measure {

namespace {

using trace::SurfacePoint;
using trace::Visibility;

constexpr int kSide = trace::SceneTracer::kBlock;
constexpr std::size_t kPixels = std::size_t(kSide) * kSide;

// Points around a centre that are asked whether the truth is another one there: eight on the circle of the tie radius,
// and eight, turned by half a step, on the circle half as wide, for what is too thin to reach the outer one.
constexpr int kDirections = 8;

dvec2 pointAround(int step, double tieRadiusPx) {
    const double radius = tieRadiusPx / (1 + step % 2), angle = glm::pi<double>() * step / kDirections;
    return dvec2(0.5) + radius * dvec2(std::cos(angle), std::sin(angle));
}

/// The pixels of one tile: as many as kSide on a side, fewer at the picture's borders.
struct Tile {
    ivec2 corner, size;
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(size.x * size.y); }
};

struct Answers {
    std::array<SurfacePoint, kPixels> points;
    std::array<Visibility, kPixels> visibility;
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

    /// The answer if a pixel showed this triangle, whatever lies before it. The eye ray may pass it at a hair's breadth:
    /// the point is where it meets the triangle's plane. Nothing where the triangle has a hole: if its border were near
    /// enough for rounding, points around the centre would have seen so.
    [[nodiscard]] std::optional<Visibility> ofPrimitive(std::uint32_t primitive, dvec2 pixel) const {
        if (primitive == trace::kNoPrimitive) return Visibility::noSurface;
        const trace::Ray ray = rays_.through(pixel);
        const trace::Triangle& t = tracer_.world().triangles[primitive];
        const dvec3 normal = glm::cross(t.b - t.a, t.c - t.a);
        const double along = glm::dot(normal, ray.directionCentred);
        if (along == 0) return Visibility::turnedAway; // the eye sees its edge
        const dvec3 point =
            ray.originCentred + glm::dot(normal, t.a - ray.originCentred) / along * ray.directionCentred;
        const double area = glm::dot(normal, normal);
        const dvec2 weights(glm::dot(normal, glm::cross(t.c - t.b, point - t.b)) / area,
                            glm::dot(normal, glm::cross(t.a - t.c, point - t.c)) / area);
        const SurfacePoint shown{primitive, along < 0, weights};
        if (tracer_.isInHole(shown)) return std::nullopt;
        return tracer_.visibility(shown, light_);
    }

    [[nodiscard]] std::uint32_t objectOf(const SurfacePoint& point) const {
        return point ? tracer_.world().objects[point.primitive] : trace::kNoPrimitive;
    }

private:
    const trace::SceneTracer& tracer_;
    trace::EyeRays rays_;
    int light_;
};

void forEachTile(ivec2 size, const std::stop_token& stop, const std::function<void(const Tile&)>& work) {
    const ivec2 tiles = (size + kSide - 1) / kSide;
    const auto workOn = [&](std::size_t i) {
        const ivec2 corner = kSide * ivec2(static_cast<int>(i) % tiles.x, static_cast<int>(i) / tiles.x);
        work({corner, glm::min(ivec2(kSide), size - corner)});
    };
    trace::parallelFor(static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y), workOn, stop);
}

/// Calls visit(index in the picture, index in the tile, pixel).
template <typename Visit>
void forEachPixel(const Tile& tile, const Truth& truth, const Visit& visit) {
    for (int y = 0; y < tile.size.y; ++y)
        for (int x = 0; x < tile.size.x; ++x)
            visit(truth.index(tile.corner.x + x, tile.corner.y + y), static_cast<std::size_t>(y * tile.size.x + x),
                  tile.corner + ivec2(x, y));
}

/// Asks the centres and then, tile by tile, whatever else `more` wants to know.
Truth askCentres(const Asking& asking, ivec2 size, const std::stop_token& stop,
                 const std::function<void(const Tile&, const Answers&, Truth&)>& more) {
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    Truth truth{size, std::vector(pixels, Visibility::noSurface), std::vector(pixels, trace::kNoPrimitive),
                std::vector<std::uint8_t>(pixels, 0)};
    forEachTile(size, stop, [&](const Tile& tile) {
        Answers centres;
        asking.ask(tile, dvec2(0.5), centres);
        forEachPixel(tile, truth, [&](std::size_t i, std::size_t inTile, ivec2) {
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
                     const std::stop_token& stop) {
    return askCentres(Asking(tracer, camera, size, light), size, stop, [](const Tile&, const Answers&, Truth&) {});
}

std::vector<std::uint8_t> tiesAmong(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size,
                                    int light, double tieRadiusPx, const std::vector<ivec2>& pixels) {
    const Asking asking(tracer, camera, size, light);
    std::vector<std::uint8_t> ties(pixels.size(), 0);
    trace::parallelFor(pixels.size(), [&](std::size_t i) {
        const Tile tile{pixels[i], ivec2(1)};
        Answers centre, around;
        asking.ask(tile, dvec2(0.5), centre);
        for (int step = 0; step < 2 * kDirections && !ties[i]; ++step) {
            asking.ask(tile, pointAround(step, tieRadiusPx), around);
            ties[i] = around.visibility[0] != centre.visibility[0];
        }
    });
    return ties;
}

Truth exactTruth(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size, int light,
                 const Rasterised& rasterised, const std::stop_token& stop) {
    const Asking asking(tracer, camera, size, light);
    return askCentres(asking, size, stop, [&](const Tile& tile, const Answers& centres, Truth& truth) {
        Answers around;
        for (int step = 0; step < 2 * kDirections; ++step) {
            asking.ask(tile, pointAround(step, rasterised.tieRadiusPx), around);
            forEachPixel(tile, truth, [&](std::size_t i, std::size_t inTile, ivec2) {
                if (around.visibility[inTile] != centres.visibility[inTile]) truth.ties[i] = 1;
            });
        }
        if (rasterised.primitives.empty()) return;
        forEachPixel(tile, truth, [&](std::size_t i, std::size_t inTile, ivec2 pixel) {
            const std::uint32_t drawn = rasterised.primitives[i];
            if (drawn == centres.points[inTile].primitive) return;
            const std::optional<Visibility> other = asking.ofPrimitive(drawn, dvec2(pixel) + 0.5);
            if (other && *other != centres.visibility[inTile]) truth.ties[i] = 1;
        });
    });
}

} // namespace shadowlab::measure
