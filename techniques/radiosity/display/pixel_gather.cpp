// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/pixel_gather.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/math/perpendicular.h"
#include "techniques/foundation/scene/query/shading.h"
#include "techniques/foundation/trace/blocks.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::radiosity {

namespace {

constexpr int kBlockSide = trace::SceneTracer::kBlock;

/// A place of its own in the unit square for each pixel, by which the sequence of all pixels is shifted (R. Cranley and T. Patterson,
/// "Randomization of Number Theoretic Methods for Multiple Integration", SIAM Journal on Numerical Analysis 13, 1976): else all pixels
/// would make the same error, and one would see it as edges. The hash is SplitMix64 (Steele, Lea and Flood 2014).
dvec2 shiftOf(ivec2 pixel) {
    std::uint64_t key = static_cast<std::uint32_t>(pixel.x) | (static_cast<std::uint64_t>(static_cast<std::uint32_t>(pixel.y)) << 32);
    key += 0x9e3779b97f4a7c15u;
    key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9u;
    key = (key ^ (key >> 27)) * 0x94d049bb133111ebu;
    key ^= key >> 31;
    return dvec2(static_cast<double>(key & 0xffffffffu), static_cast<double>(key >> 32)) * 0x1p-32;
}

/// The points of a sequence whose beginnings fill the unit square evenly, however long they are: multiples of the powers of 1 / p,
/// where p^3 = p + 1 (M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018).
dvec2 pointOf(std::size_t number) {
    constexpr double kPlastic = 1.3247179572447460;
    return glm::fract((static_cast<double>(number) + 0.5) * dvec2(1 / kPlastic, 1 / (kPlastic * kPlastic)));
}

/// A direction about the normal; those near it are more likely, by the cosine, so all directions count alike.
dvec3 cosineDirection(const dvec3& normal, const dvec2& place) {
    const double radius = std::sqrt(place.x), turn = glm::two_pi<double>() * place.y;
    const dvec3 u = perpendicularTo(normal), v = glm::cross(normal, u);
    return radius * (std::cos(turn) * u + std::sin(turn) * v) + std::sqrt(std::max(0.0, 1 - place.x)) * normal;
}

/// The triangle's own normal, on the side from which the point was found.
dvec3 geometricNormal(const trace::SceneTracer& tracer, const trace::SurfacePoint& point) {
    const trace::Triangle& t = tracer.bvh().triangles[point.primitive];
    const dvec3 normal = glm::normalize(glm::cross(t.b - t.a, t.c - t.a));
    return point.eyeOnFront ? normal : -normal;
}

std::optional<std::uint32_t> patchOf(const SurfaceCells& cells, const trace::SceneTracer& tracer, const trace::SurfacePoint& point) {
    const scene::Mesh& mesh = *tracer.objectOf(point).mesh;
    const std::uint32_t triangle = point.primitive - tracer.world().firstOfObject[tracer.world().objects[point.primitive]];
    const dvec3 weights = point.barycentric();
    dvec3 positionMesh(0);
    for (int i = 0; i < 3; ++i)
        positionMesh += weights[i] * dvec3(mesh.positionsMesh[mesh.triangles[triangle][i]]);
    return patchAt(cells, point.primitive, point.eyeOnFront, vec3(positionMesh));
}

} // namespace

bool PixelGather::advance(const Solution& solution, const PixelLight& light, std::size_t samples, Deadline deadline) {
    const scene::Scene& scene = light.tracer().scene();
    if (Key key{solution.version, light.seenFrom(), scene.lights}; done_ + nextBlock_ == 0 || key != key_) {
        key_ = std::move(key);
        size_ = light.size();
        sums_.assign(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y), dvec3(0));
        done_ = nextBlock_ = 0;
    }
    const std::size_t blocks = trace::Blocks{size_, kBlockSide}.count();
    while (done_ < samples) {
        nextBlock_ = trace::parallelUntil(deadline, nextBlock_, blocks, [&](std::size_t block) { gatherBlock(solution, light, block); });
        if (nextBlock_ < blocks) return false;
        nextBlock_ = 0;
        ++done_;
    }
    return true;
}

// [anchor: final-gather]
void PixelGather::gatherBlock(const Solution& solution, const PixelLight& light, std::size_t block) {
    const trace::Blocks all{size_, kBlockSide};
    const ivec2 corner = all.corner(block), size = all.sizeAt(corner);
    const std::span<const trace::SurfacePoint> points = light.pointsOf(block);
    const trace::SceneTracer& tracer = light.tracer();
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const trace::SurfacePoint& point = points[static_cast<std::size_t>(y * size.x + x)];
            if (!point) continue;
            const ivec2 pixel = corner + ivec2(x, y);
            const dvec3 toViewerWorld = glm::normalize(light.seenFrom().camera.positionWorld - tracer.positionWorld(point));
            const dvec3 normal = light.normals().towardWorld(toViewerWorld, point);
            const dvec3 direction = cosineDirection(normal, glm::fract(pointOf(done_) + shiftOf(pixel)));
            // A smooth normal leans: what would go through the surface is turned back to its side. (Simplified: near the rim of a round
            // body some directions then count twice, and others not at all.)
            const dvec3 flat = geometricNormal(tracer, point);
            const double below = std::min(0.0, glm::dot(direction, flat));
            sums_[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(pixel.x)] +=
                arrivingAlong(solution, light, point, direction - 2 * below * flat);
        }
}

/// Radiosity of what the ray meets: the irradiance, if all of the half sphere were like that.
dvec3 PixelGather::arrivingAlong(const Solution& solution, const PixelLight& light, const trace::SurfacePoint& from,
                                 const dvec3& directionWorld) const {
    const trace::SurfacePoint met = light.tracer().nextPoint(from, directionWorld);
    return met ? radiosityAt(solution, light, met) : glm::pi<double>() * solution.outside;
}

dvec3 PixelGather::radiosityAt(const Solution& solution, const PixelLight& light, const trace::SurfacePoint& point) const {
    const trace::SceneTracer& tracer = light.tracer();
    // What a lamp sends is direct light, which has been counted.
    if (tracer.objectOf(point).emitterOfLight >= 0) return dvec3(0);
    const auto patch = patchOf(solution.cache.cells(), tracer, point);
    if (!patch) return dvec3(0); // the inside of a closed body: dark
    dvec3 irradiance = solution.reflectedIrradiance[*patch];
    for (int i = 0; i < static_cast<int>(tracer.scene().lights.size()); ++i) {
        const scene::Light& source = tracer.scene().light(i);
        if (scene::hasArea(source))
            irradiance += solution.cache.light(i).irradiance[*patch];
        else if (tracer.visibility(point, i) == trace::Visibility::lit)
            irradiance += scene::irradiance(source, tracer.positionWorld(point), geometricNormal(tracer, point));
    }
    return solution.sources.emission[*patch] + solution.sources.reflectance[*patch] * irradiance;
}

std::vector<vec4> PixelGather::irradianceFromBelow() const {
    std::vector<vec4> irradiance(sums_.size());
    const auto width = static_cast<std::size_t>(size_.x), height = static_cast<std::size_t>(size_.y);
    // Pixels of a sample that is not complete have one ray more than the others.
    const trace::Blocks all{size_, kBlockSide};
    for (std::size_t block = 0; block < all.count(); ++block) {
        const ivec2 corner = all.corner(block), end = corner + all.sizeAt(corner);
        const double rays = static_cast<double>(done_ + (block < nextBlock_ ? 1 : 0));
        for (int y = corner.y; y < end.y; ++y)
            for (int x = corner.x; x < end.x; ++x) {
                const auto row = static_cast<std::size_t>(y), column = static_cast<std::size_t>(x);
                irradiance[(height - 1 - row) * width + column] = vec4(vec3(sums_[row * width + column] / std::max(1.0, rays)), 1.0f);
            }
    }
    return irradiance;
}

} // namespace shadowlab::radiosity
