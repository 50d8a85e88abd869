// SPDX-License-Identifier: MIT
#include "techniques/radiosity/look_around.h"

#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/radiosity/even_places.h"

namespace shadowlab::radiosity {

namespace {

// Evenly spread, their share is right to a hundredth or so: the light of the surroundings is no more exact than that.
constexpr int kRays = 256;

/// Two unit vectors that make a right-handed frame with the normal.
std::array<dvec3, 2> tangents(const dvec3& normal) {
    const dvec3 other = std::abs(normal.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    const dvec3 first = glm::normalize(glm::cross(other, normal));
    return {first, glm::cross(normal, first)};
}

} // namespace

Seen lookAround(const trace::SceneTracer& tracer, const Sides& sides, const Patch& patch, double foldMetres) {
    const auto [tangent, bitangent] = tangents(patch.normal);
    const std::uint32_t object = sides.faces.all[patch.face].object;
    int nothing = 0, insides = 0, folds = 0;
    for (int i = 0; i < kRays; ++i) {
        const auto x = evenly(i, kRays);
        // Off the surface by as little as what touches may be off.
        const dvec3 from =
            placeIn(patch.polygon, x[0], x[1]).point + 2 * kTouching * sizeOf(patch.polygon) * patch.normal;
        // Points of a unit disc, evenly, are the feet of directions by the cosine law (Malley, 1988).
        const double radius = std::sqrt(x[2]), angle = glm::two_pi<double>() * x[3];
        const dvec3 direction = radius * (std::cos(angle) * tangent + std::sin(angle) * bitangent) +
                                std::sqrt(std::max(0.0, 1 - x[2])) * patch.normal;
        const trace::SurfacePoint met = tracer.nextPoint(from, trace::kNoPrimitive, direction);
        if (!met) {
            ++nothing;
            continue;
        }
        insides += !met.eyeOnFront && sides.backOfTriangle[met.primitive] == kNoFace;
        folds += tracer.world().objects[met.primitive] == object &&
                 glm::distance(tracer.positionCentred(met), from) < foldMetres;
    }
    const auto share = [](int rays) { return static_cast<double>(rays) / kRays; };
    return {share(nothing), share(insides), share(folds)};
}

} // namespace shadowlab::radiosity
