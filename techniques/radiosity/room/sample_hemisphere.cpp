// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/sample_hemisphere.h"

#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/radiosity/patches/polygon_samples.h"

namespace shadowlab::radiosity {

namespace {

// With Hammersley points the shares are right to about a hundredth, which is enough for light from the surroundings.
constexpr int kRaysAround = 256;

// But where less than this share of the view is no surface, a hundredth is a large part of it. In a room with a window that is all the light
// there is: there so many rays look.
constexpr double kSmallView = 0.2;
constexpr std::size_t kRaysOfSmallView = 2048;
constexpr double kRaysInAll = kRaysAround + kRaysOfSmallView;

// One ray in so many is followed to its end to find whether it starts inside a body. The answer is the same nearly everywhere on
// a patch, so few will do.
constexpr int kRaysPerWay = 8;

/// Two unit vectors that form a right-handed frame with the normal.
std::array<dvec3, 2> tangents(const dvec3& normal) {
    const dvec3 other = std::abs(normal.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    const dvec3 first = glm::normalize(glm::cross(other, normal));
    return {first, glm::cross(normal, first)};
}

// Rays start off the edges of a patch by this share of the way to its centre. Where the patch meets another one, a place on the very edge may lie behind that, by
// rounding, and the ray would leave a closed room. Less than one place in a thousand is moved farther than to the next.
constexpr double kOffEdges = 1e-3;

/// Number `i` of so many. Off the surface by twice the contact tolerance.
HemisphereRay rayOf(const Patch& patch, const std::array<dvec3, 2>& tangents, int i, int count) {
    const auto x = hammersley4(i, count);
    const dvec3 place = glm::mix(placeIn(patch.polygon, x[0], x[1]).point, patch.centre, kOffEdges);
    const dvec3 from = place + 2 * kTouching * sizeOf(patch.polygon) * patch.normal;
    return {from, cosineDirection(tangents, patch.normal, {x[2], x[3]})};
}

} // namespace

dvec3 cosineDirection(const std::array<dvec3, 2>& tangents, const dvec3& normal, const dvec2& unit) {
    // Uniform points of the unit disc, projected up to the hemisphere (Malley, 1988).
    const double radius = std::sqrt(unit.x), angle = glm::two_pi<double>() * unit.y;
    return radius * (std::cos(angle) * tangents[0] + std::sin(angle) * tangents[1]) + std::sqrt(std::max(0.0, 1 - unit.x)) * normal;
}

std::vector<HemisphereRay> outwardRays(const trace::SceneTracer& tracer, const Patch& patch, std::size_t count) {
    const std::array<dvec3, 2> frame = tangents(patch.normal);
    std::vector<HemisphereRay> outward;
    for (int i = 0; i < static_cast<int>(count); ++i)
        if (const HemisphereRay one = rayOf(patch, frame, i, static_cast<int>(count)); !tracer.nextPoint(one.fromCentred, trace::kNoPrimitive, one.direction))
            outward.push_back(one);
    return outward;
}

HemisphereShares sampleHemisphere(const trace::SceneTracer& tracer, const ClosedBodies& bodies, const Patch& patch,
                                  std::uint32_t object, double foldMetres) {
    const std::array<dvec3, 2> frame = tangents(patch.normal);
    int nothing = 0, inBodies = 0, folds = 0;
    for (int i = 0; i < kRaysAround; ++i) {
        const auto [from, direction] = rayOf(patch, frame, i, kRaysAround);
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
    HemisphereShares shares{share(nothing), kRaysPerWay * share(inBodies), share(folds)};
    if (shares.nothing > 0 && shares.nothing < kSmallView) shares.nothing = nothing / kRaysInAll + smallView(tracer, patch);
    return shares;
}

double smallView(const trace::SceneTracer& tracer, const Patch& patch) {
    return static_cast<double>(outwardRays(tracer, patch, kRaysOfSmallView).size()) / kRaysInAll;
}

} // namespace shadowlab::radiosity
