// SPDX-License-Identifier: MIT
#include "techniques/radiosity/lights/light_source.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/math/perpendicular.h"
#include "techniques/foundation/scene/query/shading.h"
#include "techniques/radiosity/form_factors/point_form_factor.h"
#include "techniques/radiosity/form_factors/polygon_exchange.h"
#include "techniques/radiosity/lights/solid_angle.h"
#include "techniques/radiosity/patches/polygon_samples.h"

namespace shadowlab::radiosity {

namespace {

// Sample points for the mean irradiance by a sphere that the patch's plane cuts, which has no closed form.
constexpr int kPlaces = 256;

// Sides of a pyramid around a spot's cone: the cone fills nine tenths of it.
constexpr int kSidesAroundCone = 6;

} // namespace

LightSource::LightSource(const scene::Light& light, const dvec3& originWorld, const Faces& faces)
    : light_(light), color_(light.color) {
    light_.color = vec3(1);
    light_.positionWorld -= originWorld;
    cone_ = {light_.positionWorld, light.directionWorld, glm::radians(0.5 * light.coneDegrees),
             glm::radians(light.edgeDegrees)};
    if (light.type == scene::LightType::rect) {
        const dvec3 &middle = light_.positionWorld, u = 0.5 * light.edgeUWorld, v = 0.5 * light.edgeVWorld;
        rect_ = {middle - u - v, middle + u - v, middle + u + v, middle - u + v};
    }
    trace::CentredBox box;
    for (const Face& face : faces.all)
        for (const dvec3& corner : face.polygon.corners())
            box.include(corner);
    // Twice the diagonal, so that the point lies well outside the box.
    if (!faces.all.empty()) beyond_ = 2 * glm::length(box.upper - box.lower);
}

trace::CentredBox LightSource::box() const {
    trace::CentredBox box;
    if (light_.type == scene::LightType::rect) return boxOf(rect_);
    box.include(light_.positionWorld);
    box.grow(light_.radius);
    return box;
}

std::vector<Plane> LightSource::fronts() const {
    return light_.type == scene::LightType::rect ? std::vector{planeOf(rect_)} : std::vector<Plane>();
}

double LightSource::touching(const dvec3& positionCentred) const {
    return kTouching * glm::distance(positionCentred, light_.positionWorld);
}

double LightSource::irradiance(const dvec3& positionCentred, const dvec3& normal) const {
    if (light_.type == scene::LightType::sphere) return ofSphere(positionCentred, normal);
    if (light_.type == scene::LightType::rect) {
        const double touches = touching(positionCentred) + kTouching * sizeOf(rect_);
        if (!(planeOf(rect_).height(positionCentred) > touches)) return 0;
        const Polygon before = partBefore({positionCentred, normal}, rect_, touches);
        if (before.isEmpty()) return 0;
        return glm::pi<double>() * light_.intensity * pointFormFactor(positionCentred, normal, before);
    }
    const dvec4 place = scene::homogeneousPositionWorld(light_);
    if (!(glm::dot(normal, dvec3(place) - place.w * positionCentred) > 0)) return 0;
    return scene::lightShinesTo(light_, positionCentred) ? scene::irradiance(light_, positionCentred, normal).x : 0;
}

/// A sphere that the horizon cuts. x is the cotangent of the half angle under which the sphere is seen; acos(y) is half the angle
/// of that part of its outline that lies above the horizon.
double LightSource::ofSphere(const dvec3& positionCentred, const dvec3& normal) const {
    const dvec3 toLight = light_.positionWorld - positionCentred;
    const double squared = glm::dot(toLight, toLight), radius = light_.radius;
    const double height = glm::dot(normal, toLight);
    if (!(squared > radius * radius) || height <= -radius)
        return 0; // the point is inside, or the sphere below the horizon
    const double share = radius * radius / squared, cosine = height / std::sqrt(squared);
    if (height >= radius) return glm::pi<double>() * light_.intensity * share * cosine;
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double x = std::sqrt(1 / share - 1), y = std::clamp(-x * cosine / sine, -1.0, 1.0);
    const double cut = sine * std::sqrt(1 - y * y);
    return light_.intensity * std::max(0.0, (cosine * std::acos(y) - x * cut) * share + std::atan(cut / x));
}

double LightSource::meanIrradiance(const Patch& patch) const {
    const dvec3& position = light_.positionWorld;
    const double height = patch.plane().height(position);
    switch (light_.type) {
    case scene::LightType::directional: return irradiance(patch.centre, patch.normal);
    case scene::LightType::point:
        if (!(height > touching(patch.centre))) return 0;
        return light_.intensity * solidAngle(patch.polygon, position) / patch.area;
    case scene::LightType::spot:
        if (!(height > touching(patch.centre))) return 0;
        return light_.intensity * coneSolidAngle(cone_, patch.polygon) / patch.area;
    case scene::LightType::rect:
        return glm::pi<double>() * light_.intensity * unoccludedExchange(patch.polygon, rect_).area / patch.area;
    case scene::LightType::sphere: break;
    }
    if (height <= -light_.radius) return 0;
    if (height >= light_.radius)
        return scene::pointIntensity(light_) * solidAngle(patch.polygon, position) / patch.area;
    double sum = 0, weights = 0;
    for (int i = 0; i < kPlaces; ++i) {
        const auto x = hammersley4(i, kPlaces);
        const Place place = placeIn(patch.polygon, x[0], x[1]);
        if (glm::distance(place.point, position) < light_.radius) continue;
        sum += place.weight * irradiance(place.point, patch.normal);
        weights += place.weight;
    }
    return weights > 0 ? sum / weights : 0;
}

/// The part of the polygon within a pyramid around the spot's cone.
Polygon LightSource::withinCone(Polygon polygon) const {
    const dvec3 u = perpendicularTo(cone_.axis), v = glm::cross(cone_.axis, u);
    for (int i = 0; i < kSidesAroundCone; ++i) {
        const double turn = glm::two_pi<double>() * i / kSidesAroundCone;
        const dvec3 outward = std::cos(turn) * u + std::sin(turn) * v;
        const Plane side{cone_.apex, std::sin(cone_.half) * cone_.axis - std::cos(cone_.half) * outward};
        if (polygon.count() < Polygon::kMostCorners) polygon = partBefore(side, polygon, 0); // a cut adds a corner
    }
    return polygon;
}

Polygon LightSource::reached(const Patch& patch) const {
    if (light_.type == scene::LightType::spot) return withinCone(patch.polygon);
    if (light_.type == scene::LightType::rect) return partBefore(planeOf(rect_), patch.polygon, touching(patch.centre));
    return patch.polygon;
}

LightLine LightSource::line(const dvec3& positionCentred, const dvec3& normal, double s, double t) const {
    switch (light_.type) {
    case scene::LightType::directional: {
        const dvec3 from = positionCentred - beyond_ * light_.directionWorld;
        return {from, irradiance(positionCentred, normal)};
    }
    case scene::LightType::rect: {
        const dvec3 from = placeIn(rect_, s, t).point, way = from - positionCentred;
        const double squared = glm::dot(way, way), atPoint = glm::dot(normal, way);
        const double atLight = -glm::dot(scene::rectNormalWorld(light_), way);
        return {from, std::max(0.0, atPoint) * std::max(0.0, atLight) / (squared * squared)};
    }
    case scene::LightType::sphere: return lineFromSphere(positionCentred, normal, s, t);
    default: return {light_.positionWorld, irradiance(positionCentred, normal)};
    }
}

/// Uniform in the cone under which the sphere is seen: P. Shirley, C. Wang and K. Zimmerman, "Monte Carlo Techniques for Direct
/// Lighting Calculations", ACM Transactions on Graphics 15(1), 1996.
LightLine LightSource::lineFromSphere(const dvec3& positionCentred, const dvec3& normal, double s, double t) const {
    const dvec3 toLight = light_.positionWorld - positionCentred;
    const double distance = glm::length(toLight), sineSquared = std::pow(light_.radius / distance, 2);
    if (!(sineSquared < 1)) return {light_.positionWorld, 0};
    const double extent = sineSquared / (1 + std::sqrt(1 - sineSquared)); // 1 - cosine, without cancellation
    const double cosine = 1 - s * extent, sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double turn = glm::two_pi<double>() * t;
    const dvec3 axis = toLight / distance, u = perpendicularTo(axis), v = glm::cross(axis, u);
    const dvec3 way = cosine / distance * toLight + sine * (std::cos(turn) * u + std::sin(turn) * v);
    const double inside = std::pow(light_.radius, 2) - std::pow(distance * sine, 2);
    const double length = distance * cosine - std::sqrt(std::max(0.0, inside));
    return {positionCentred + length * way, extent * std::max(0.0, glm::dot(normal, way))};
}

Polygon LightSource::hull(const Polygon& polygon) const {
    Polygon hull;
    switch (light_.type) {
    case scene::LightType::directional:
        for (const dvec3& corner : polygon.corners())
            hull.add(corner - beyond_ * light_.directionWorld);
        break;
    case scene::LightType::sphere:
        for (int i = 0; i < 8; ++i)
            hull.add(light_.positionWorld + light_.radius * dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
        break;
    case scene::LightType::rect: return rect_;
    default: hull.add(light_.positionWorld);
    }
    return hull;
}

Blockers LightSource::blockers(const Polygon& polygon, const Occlusion& occlusion) const {
    return light_.type == scene::LightType::rect ? occlusion.between(polygon, rect_)
                                                 : occlusion.betweenHull(polygon, hull(polygon));
}

bool LightSource::isHidden(const Polygon& polygon, const Occlusion& occlusion, const Blockers& blockers) const {
    return occlusion.blocksAll(blockers, polygon, hull(polygon));
}

} // namespace shadowlab::radiosity
