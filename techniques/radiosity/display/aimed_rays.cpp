// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/aimed_rays.h"

#include <algorithm>

#include <glm/gtc/constants.hpp>

namespace shadowlab::radiosity {

namespace {

// A ray that ends before this share of its way is lacking has arrived: meshes are rounded to floats.
constexpr double kSamePlace = 1e-5;

// Seen along its own plane, a surface is no smaller than this cosine makes it.
constexpr double kLeastCosine = 1e-9;

} // namespace

double densityOfDirection(double density, double distance, double cosineThere) {
    return density * distance * distance / std::max(cosineThere, kLeastCosine);
}

dvec3 geometricNormal(const trace::SceneTracer& tracer, const trace::SurfacePoint& point) {
    const trace::Triangle& t = tracer.bvh().triangles[point.primitive];
    const dvec3 normal = glm::normalize(trace::frontOf(t));
    return point.eyeOnFront ? normal : -normal;
}

std::optional<Aim> aimAt(const dvec3& positionWorld, const dvec3& facing, const trace::SceneTracer& tracer, const RayOrigin& from) {
    const dvec3 way = positionWorld - tracer.positionWorld(from.point);
    const double distance = glm::length(way);
    if (!(distance > kContactDistance)) return std::nullopt;
    const dvec3 direction = way / distance;
    const Aim aim{direction, distance, glm::dot(direction, from.normal), -glm::dot(direction, facing)};
    if (aim.cosineHere <= 0 || aim.cosineThere <= 0 || glm::dot(direction, from.flat) <= 0) return std::nullopt;
    return aim;
}

// [anchor: chosen-point]
std::optional<Met> chosenPoint(const GatherGuide& guide, const trace::SceneTracer& tracer, const RayOrigin& from, double which, const dvec2& where) {
    const GatherGuide::Choice chosen = guide.choose(*from.patch, which, where);
    const auto aim = aimAt(chosen.positionWorld, chosen.normal, tracer, from);
    if (!aim) return std::nullopt;
    const trace::SurfacePoint met = tracer.nextPoint(from.point, aim->direction);
    if (!met || glm::distance(tracer.positionWorld(met), tracer.positionWorld(from.point)) < (1 - kSamePlace) * aim->distance) return std::nullopt;
    const double byChance = aim->cosineHere / glm::pi<double>();
    const double byChoice = densityOfDirection(guide.density(*from.patch, chosen.patch), aim->distance, aim->cosineThere);
    const double density = densityOfDirection(chosen.density, aim->distance, aim->cosineThere);
    return Met{met, aim->distance, balanced(byChoice, byChance) * byChance / density};
}

double shareByChance(const GatherGuide& guide, const RayOrigin& from, const std::optional<std::uint32_t>& patchThere, double distance, double cosineHere,
                     double cosineThere) {
    if (!from.patch || !patchThere) return 1;
    return balanced(cosineHere / glm::pi<double>(), densityOfDirection(guide.density(*from.patch, *patchThere), distance, cosineThere));
}

} // namespace shadowlab::radiosity
