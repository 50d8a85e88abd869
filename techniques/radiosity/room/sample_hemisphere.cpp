// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/sample_hemisphere.h"

#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/radiosity/patches/polygon_samples.h"

namespace shadowlab::radiosity {

namespace {

// With Hammersley points the shares are right to about a hundredth, which is enough for light from the surroundings.
constexpr int kRaysAround = 256;

// One ray in so many is followed to its end to find whether it starts inside a body. The answer is the same nearly everywhere on
// a patch, so few will do.
constexpr int kRaysPerWay = 8;

/// Two unit vectors that form a right-handed frame with the normal.
std::array<dvec3, 2> tangents(const dvec3& normal) {
    const dvec3 other = std::abs(normal.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    const dvec3 first = glm::normalize(glm::cross(other, normal));
    return {first, glm::cross(normal, first)};
}

} // namespace

HemisphereShares sampleHemisphere(const trace::SceneTracer& tracer, const ClosedBodies& bodies, const Patch& patch,
                                  std::uint32_t object, double foldMetres) {
    const auto [tangent, bitangent] = tangents(patch.normal);
    int nothing = 0, inBodies = 0, folds = 0;
    for (int i = 0; i < kRaysAround; ++i) {
        const auto x = hammersley4(i, kRaysAround);
        // Off the surface by twice the contact tolerance.
        const dvec3 from =
            placeIn(patch.polygon, x[0], x[1]).point + 2 * kTouching * sizeOf(patch.polygon) * patch.normal;
        // Uniform points of the unit disc, projected up to the hemisphere, are cosine-distributed directions (Malley, 1988).
        const double radius = std::sqrt(x[2]), angle = glm::two_pi<double>() * x[3];
        const dvec3 direction = radius * (std::cos(angle) * tangent + std::sin(angle) * bitangent) +
                                std::sqrt(std::max(0.0, 1 - x[2])) * patch.normal;
        inBodies += i % kRaysPerWay == 0 && bodies.contain(from, direction);
        const trace::SurfacePoint hit = tracer.nextPoint(from, trace::kNoPrimitive, direction);
        if (!hit) {
            ++nothing;
            continue;
        }
        folds += tracer.world().objects[hit.primitive] == object &&
                 glm::distance(tracer.positionCentred(hit), from) < foldMetres;
    }
    const auto share = [](int rays) { return static_cast<double>(rays) / kRaysAround; };
    return {share(nothing), kRaysPerWay * share(inBodies), share(folds)};
}

} // namespace shadowlab::radiosity
