// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/aimed_rays.h"

#include <algorithm>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/math/perpendicular.h"
#include "techniques/foundation/scene/model/surface_color.h"
#include "techniques/radiosity/room/sample_hemisphere.h"

namespace shadowlab::radiosity {

namespace {

// A ray that ends before this share of its way is lacking has arrived: meshes are rounded to floats.
constexpr double kSamePlace = 1e-5;

} // namespace

dvec3 geometricNormal(const trace::SceneTracer& tracer, const trace::SurfacePoint& point) {
    const trace::Triangle& t = tracer.bvh().triangles[point.primitive];
    const dvec3 normal = glm::normalize(trace::frontOf(t));
    return point.eyeOnFront ? normal : -normal;
}

dvec3 reflectanceAt(const trace::SceneTracer& tracer, const trace::SurfacePoint& point) {
    return dvec3(scene::diffuseAt(tracer.scene(), tracer.objectOf(point), tracer.world().triangleInMesh(point.primitive), point.barycentric()));
}

dvec3 emittedAt(const trace::SceneTracer& tracer, const trace::SurfacePoint& point) {
    const scene::Object& object = tracer.objectOf(point);
    const scene::Material& material = scene::materialOfTriangle(tracer.scene(), object, tracer.world().triangleInMesh(point.primitive));
    return scene::shinesFrom(material, point.eyeOnFront != scene::isMirrored(object)) ? glm::pi<double>() * dvec3(material.emission) : dvec3(0);
}

trace::SurfacePoint placeOn(const trace::SurfacePoint& side, dvec2 unit) {
    if (unit.x + unit.y > 1) unit = 1.0 - unit; // the square, folded along its diagonal
    return {side.primitive, side.eyeOnFront, unit};
}

dvec3 diffuseDirection(const trace::SceneTracer& tracer, const trace::SurfacePoint& from, const dvec2& unit) {
    const dvec3 normal = geometricNormal(tracer, from), tangent = perpendicularTo(normal);
    return cosineDirection({tangent, glm::cross(normal, tangent)}, normal, unit);
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
    const auto way = guide.choose(*from.patch, tracer.positionWorld(from.point), which, where);
    if (!way) return std::nullopt;
    const double cosineHere = glm::dot(way->direction, from.normal);
    if (cosineHere <= 0 || glm::dot(way->direction, from.flat) <= 0) return std::nullopt;
    const trace::SurfacePoint met = tracer.nextPoint(from.point, way->direction);
    if (!met) return std::nullopt;
    const double distance = glm::distance(tracer.positionCentred(met), tracer.positionCentred(from.point));
    const bool isChosen = way->object ? tracer.world().objects[met.primitive] == *way->object : distance >= (1 - kSamePlace) * way->distance;
    if (!isChosen) return std::nullopt;
    // Counted by the balance heuristic: its share, way->density / (way->density + byChance), times byChance / way->density.
    const double byChance = cosineHere / glm::pi<double>();
    return Met{met, std::max(distance, kContactDistance), byChance / (way->density + byChance)};
}

double shareByChance(const GatherGuide& guide, const trace::SceneTracer& tracer, const RayOrigin& from, const dvec3& direction, const trace::SurfacePoint& met,
                     const std::optional<std::uint32_t>& patchThere, double distance) {
    if (!from.patch || !patchThere) return 1;
    const double cosineHere = glm::dot(direction, from.normal), cosineThere = -glm::dot(direction, geometricNormal(tracer, met));
    const double byChoice = guide.density(*from.patch, tracer.positionWorld(from.point), direction, {*patchThere, distance, cosineThere, tracer.world().triangleInMesh(met.primitive)});
    return balanced(cosineHere / glm::pi<double>(), byChoice);
}

} // namespace shadowlab::radiosity
