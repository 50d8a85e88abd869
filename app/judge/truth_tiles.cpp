// SPDX-License-Identifier: MIT
#include "app/judge/truth_tiles.h"

#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::judge {

dvec2 pointAround(int step, double tieRadiusPx) {
    const double radius = tieRadiusPx / (1 + step % 2), angle = glm::two_pi<double>() * step / kPointsAround;
    return dvec2(0.5) + radius * dvec2(std::cos(angle), std::sin(angle));
}

void forEachTile(ivec2 size, const std::stop_token& stop, const std::function<void(const Tile&)>& work) {
    const ivec2 tiles = (size + kTileSide - 1) / kTileSide;
    const auto workOn = [&](std::size_t i) {
        const ivec2 corner = kTileSide * ivec2(static_cast<int>(i) % tiles.x, static_cast<int>(i) / tiles.x);
        work({corner, glm::min(ivec2(kTileSide), size - corner)});
    };
    trace::parallelFor(static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y), workOn, stop);
}

std::uint32_t objectOf(const trace::SceneTracer& tracer, const trace::SurfacePoint& point) {
    return point ? tracer.world().objects[point.primitive] : trace::kNoPrimitive;
}

trace::Visibility visibilityOf(const trace::SceneTracer& tracer, int light, const trace::SurfacePoint& point, double share) {
    if (!point) return trace::Visibility::noSurface;
    if (!tracer.facesLight(point, light)) return trace::Visibility::turnedAway;
    return share > 0.5 ? trace::Visibility::lit : trace::Visibility::shadowed;
}

Truth emptyTruth(ivec2 size) {
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    return {size,
            std::vector(pixels, trace::Visibility::noSurface),
            std::vector(pixels, trace::kNoPrimitive),
            std::vector<std::uint8_t>(pixels, 0),
            {}};
}

std::optional<trace::SurfacePoint> pointOfPrimitive(const trace::SceneTracer& tracer, const trace::EyeRays& rays,
                                                    std::uint32_t primitive, dvec2 pixel) {
    const trace::Ray ray = rays.through(pixel);
    const trace::Triangle& t = tracer.world().triangles[primitive];
    const dvec3 normal = glm::cross(t.b - t.a, t.c - t.a);
    const double along = glm::dot(normal, ray.directionCentred);
    if (along == 0) return std::nullopt;
    const dvec3 point = ray.originCentred + glm::dot(normal, t.a - ray.originCentred) / along * ray.directionCentred;
    const double area = glm::dot(normal, normal);
    const dvec2 weights(glm::dot(normal, glm::cross(t.c - t.b, point - t.b)) / area,
                        glm::dot(normal, glm::cross(t.a - t.c, point - t.c)) / area);
    return trace::SurfacePoint{primitive, along < 0, weights};
}

} // namespace shadowlab::judge
