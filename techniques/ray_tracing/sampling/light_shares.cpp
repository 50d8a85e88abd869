// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/sampling/light_shares.h"

#include <algorithm>

#include "techniques/foundation/trace/blocks.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/ray_tracing/sampling/light_sampling.h"
#include "techniques/ray_tracing/tree/node_lights.h"

namespace shadowlab::ray_tracing {

void LightShares::restart(ivec2 size, int light) {
    light_ = light;
    shares_.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), 0.0f);
    irradiances_.clear();
    next_ = 0;
    isComplete_ = false;
}

bool LightShares::advance(const Surfaces& surfaces, const Picture& picture, const scene::Camera& camera,
                          const SamplePattern& pattern, Deadline deadline) {
    const ivec2 size = picture.size();
    const trace::SceneTracer& tracer = surfaces.tracer();
    const trace::MovingScene atRest(tracer);
    const Grid<trace::Visibility>& fromCentre = picture.visibility(light_);
    const auto width = static_cast<std::size_t>(size.x);
    if (next_ == 0)
        std::ranges::transform(fromCentre, shares_.begin(), [](trace::Visibility visibility) {
            return visibility == trace::Visibility::lit ? 1.0f : 0.0f;
        });
    // A piece is 64 pixels of a row.
    constexpr std::size_t kPiece = 64;
    const std::size_t piecesInRow = (width + kPiece - 1) / kPiece,
                      pieces = piecesInRow * static_cast<std::size_t>(size.y);
    next_ = trace::parallelUntil(deadline, next_, pieces, [&](std::size_t piece) {
        const std::size_t y = piece / piecesInRow, begin = piece % piecesInRow * kPiece;
        for (std::size_t x = begin; x < std::min(width, begin + kPiece); ++x) {
            const std::size_t i = y * width + x;
            if (fromCentre[i] < trace::Visibility::shadowed) continue; // turned away, or there is nothing
            const trace::SurfacePoint& point = picture.points()[i];
            const dvec3 toViewerWorld = glm::normalize(camera.positionWorld - tracer.positionWorld(point));
            shares_[i] = static_cast<float>(sampledShare({surfaces, atRest}, point, toViewerWorld, light_, pattern,
                                                         ivec2(static_cast<int>(x), static_cast<int>(y))));
        }
    });
    return isComplete_ = next_ >= pieces;
}

bool LightShares::advance(const Surfaces& surfaces, const Picture& picture, const scene::Camera& camera,
                          const trace::AreaVisibility& area, Deadline deadline) {
    // Neighbouring points are computed together, in squares.
    constexpr int kSide = 8;
    const ivec2 size = picture.size();
    const trace::Blocks squares{size, kSide};
    const trace::SceneTracer& tracer = surfaces.tracer();
    irradiances_.resize(shares_.size(), 0.0f);
    next_ = trace::parallelUntil(deadline, next_, squares.count(), [&](std::size_t square) {
        const ivec2 corner = squares.corner(square), end = corner + squares.sizeAt(corner);
        std::vector<std::size_t> pixels;
        std::vector<trace::SurfacePoint> points;
        std::vector<dvec3> normalsWorld;
        for (int y = corner.y; y < end.y; ++y)
            for (int x = corner.x; x < end.x; ++x) {
                const auto i =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
                const trace::SurfacePoint& point = picture.points()[i];
                if (!point) continue;
                pixels.push_back(i);
                points.push_back(point);
                normalsWorld.push_back(
                    surfaces.normalWorld(point, glm::normalize(camera.positionWorld - tracer.positionWorld(point))));
            }
        // [anchor: area-irradiance]
        std::vector<trace::AreaIrradiance> found(points.size());
        if (!points.empty()) area.irradiances(points, normalsWorld, found);
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            shares_[pixels[i]] = static_cast<float>(found[i].visible);
            irradiances_[pixels[i]] = static_cast<float>(found[i].irradiance);
        }
    });
    return isComplete_ = next_ >= squares.count();
}

double sampledShare(const RayWorld& world, const trace::SurfacePoint& point, const dvec3& toViewerWorld, int light,
                    const SamplePattern& pattern, ivec2 pixel) {
    const Surfaces& surfaces = world.surfaces;
    const trace::SceneTracer& tracer = surfaces.tracer();
    if (!tracer.objectOf(point).receivesShadow) return 1.0;
    TreeNode node; // as the root of a picture's tree
    node.point = point;
    node.u = -toViewerWorld;
    node.positionCentred = tracer.positionCentred(point);
    const scene::Light& source = tracer.scene().light(light);
    const LightSampler sampler(source, tracer.positionWorld(point));
    if (!(sampler.solidAngle() > 0)) return 0.0;
    double seen = 0, all = 0;
    for (int sample = 0; sample < pattern.count; ++sample) {
        const SampleNumbers numbers(pattern, pixel, static_cast<std::uint32_t>(sample));
        const std::uint64_t place = node.placeOf(light, tracer.scene().lights.size());
        const LightSample chosen = sampler.sample(numbers.pair(Purpose::light, place));
        all += chosen.areaWeight;
        if (visibilityAlong(world, {}, node, light, chosen.onLightCentredOffset) == trace::Visibility::lit)
            seen += chosen.areaWeight;
    }
    return all > 0 ? seen / all : 0.0;
}

} // namespace shadowlab::ray_tracing
