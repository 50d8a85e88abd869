// SPDX-License-Identifier: MIT
#include "tests/support/area_lights.h"

#include <cmath>
#include <random>
#include <stdexcept>

namespace shadowlab::testing {

namespace {

dvec3 normalOf(const trace::Triangle& t) { return glm::cross(t.b - t.a, t.c - t.a); }

/// Weights of corners a and b in the point of the plane that is nearest.
dvec2 weightsOf(const trace::Triangle& t, const dvec3& point) {
    const dvec3 normal = normalOf(t);
    const double area = glm::dot(normal, normal);
    return {glm::dot(normal, glm::cross(t.c - t.b, point - t.b)) / area,
            glm::dot(normal, glm::cross(t.a - t.c, point - t.c)) / area};
}

/// How far along the way is the triangle met? Moeller and Trumbore's test, 1997; infinite where it is not.
double metAt(const trace::Triangle& t, const dvec3& from, const dvec3& way) {
    const dvec3 ab = t.b - t.a, ac = t.c - t.a, p = glm::cross(way, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0) return INFINITY;
    const dvec3 s = from - t.a, q = glm::cross(s, ab);
    const double u = glm::dot(s, p) / determinant, v = glm::dot(way, q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 ? glm::dot(ac, q) / determinant : INFINITY;
}

} // namespace

scene::Light rectLight(const dvec3& centreWorld, const dvec3& edgeU, const dvec3& edgeV) {
    scene::Light light;
    light.name = "panel";
    light.type = scene::LightType::rect;
    light.positionWorld = centreWorld;
    light.edgeUWorld = edgeU;
    light.edgeVWorld = edgeV;
    light.intensity = 10;
    return light;
}

scene::Light sphereLight(const dvec3& centreWorld, double radius) {
    scene::Light light;
    light.name = "bulb";
    light.type = scene::LightType::sphere;
    light.positionWorld = centreWorld;
    light.radius = radius;
    light.intensity = 10;
    return light;
}

trace::SceneTracer tracerOf(const scene::Snapshot& snapshot) {
    trace::SceneTracer tracer;
    tracer.advance(snapshot, std::chrono::steady_clock::time_point::max());
    return tracer;
}

trace::SurfacePoint surfacePointAt(const trace::SceneTracer& tracer, std::uint32_t object, const dvec3& positionWorld) {
    const dvec3 point = positionWorld - tracer.world().originWorld;
    for (std::uint32_t primitive = 0; primitive < tracer.world().triangles.size(); ++primitive) {
        if (tracer.world().objects[primitive] != object) continue;
        const trace::Triangle& t = tracer.world().triangles[primitive];
        const dvec2 weights = weightsOf(t, point);
        const bool within = weights.x >= 0 && weights.y >= 0 && weights.x + weights.y <= 1;
        // Meshes are stored in float.
        if (within && std::abs(glm::dot(glm::normalize(normalOf(t)), point - t.a)) < 1e-5)
            return {primitive, true, weights};
    }
    throw std::logic_error("no triangle of the object is there");
}

double sampledShare(const trace::SceneTracer& tracer, const trace::SurfacePoint& point, int light, int side) {
    const scene::Light& source = tracer.scene().light(light);
    const dvec3 from = tracer.positionCentred(point);
    const dvec3 toCentre = source.positionWorld - tracer.world().originWorld - from;
    const std::vector<trace::Triangle>& triangles = tracer.world().triangles;
    const dvec3 up = (point.eyeOnFront ? 1.0 : -1.0) * normalOf(triangles[point.primitive]);
    std::mt19937 numbers(point.primitive);
    std::uniform_real_distribution<double> chance(0, 1);
    const bool isSphere = source.type == scene::LightType::sphere;
    const double distance = glm::length(toCentre), widest = isSphere ? std::asin(source.radius / distance) : 0;
    const dvec3 axis = toCentre / distance;
    const dvec3 aside = glm::normalize(glm::cross(axis, std::abs(axis.y) < 0.5 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
    const dvec3 across = glm::cross(axis, aside);
    int seen = 0;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const double u = (row + chance(numbers)) / side, v = (column + chance(numbers)) / side;
            dvec3 way = toCentre + (u - 0.5) * source.edgeUWorld + (v - 0.5) * source.edgeVWorld;
            if (isSphere) {
                const double radius = std::tan(widest) * std::sqrt(u), angle = 2 * M_PI * v;
                way = glm::normalize(axis + radius * (std::cos(angle) * aside + std::sin(angle) * across));
                const double along = glm::dot(way, toCentre);
                const double under = along * along - distance * distance + source.radius * source.radius;
                way *= along - std::sqrt(std::max(under, 0.0));
            }
            bool blocked = !(glm::dot(up, way) > 0);
            for (std::size_t i = 0; i < triangles.size() && !blocked; ++i) {
                const scene::Object& object = tracer.scene().objects[tracer.world().objects[i]];
                if (!object.castsShadow || i == point.primitive) continue;
                const double at = metAt(triangles[i], from, way);
                blocked =
                    at > trace::kContact && at < 1 &&
                    !tracer.isInHole({static_cast<std::uint32_t>(i), false, weightsOf(triangles[i], from + at * way)});
            }
            seen += blocked ? 0 : 1;
        }
    return static_cast<double>(seen) / (side * side);
}

} // namespace shadowlab::testing
