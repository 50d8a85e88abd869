// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/gather_rays.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/math/perpendicular.h"
#include "techniques/radiosity/display/aimed_rays.h"
#include "techniques/radiosity/display/ray_end.h"

namespace shadowlab::radiosity {

namespace {

/// Directions about a normal, one for each point of the sequence from `first` on; those near the normal are more likely, by the
/// cosine, so all count alike. One turns by the same angle from each to the next, so that sine and cosine are found once.
class CosineDirections {
public:
    CosineDirections(const dvec3& normal, const dvec2& shift, std::size_t first)
        : normal_(normal), u_(perpendicularTo(normal)), v_(glm::cross(normal, u_)), shift_(shift), next_(first) {
        const double turn = glm::two_pi<double>() * RayNumbers(first, shift).direction().y;
        toward_ = {std::cos(turn), std::sin(turn)};
    }
    dvec3 next() {
        static const dvec2 step{std::cos(glm::two_pi<double>() * kDirectionStep.y), std::sin(glm::two_pi<double>() * kDirectionStep.y)};
        const double square = RayNumbers(next_++, shift_).direction().x, radius = std::sqrt(square);
        const dvec3 direction = radius * (toward_.x * u_ + toward_.y * v_) + std::sqrt(1 - square) * normal_;
        toward_ = {toward_.x * step.x - toward_.y * step.y, toward_.x * step.y + toward_.y * step.x};
        return direction;
    }

private:
    dvec3 normal_, u_, v_;
    dvec2 shift_, toward_{1, 0}; ///< toward_: cosine and sine of the angle from u_
    std::size_t next_;
};

/// What a ray to a chosen point of a patch or an opening brings.
struct Brought {
    dvec3 irradiance{0.0}; ///< W/m^2
    double distance = 1;   ///< metres
};
void addTo(Gathered& sum, const Brought& brought) {
    sum.irradiance += brought.irradiance;
    sum.fromChosen += luminance(brought.irradiance);
    sum.nearnessOfChosen += luminance(brought.irradiance) / brought.distance;
}

Brought fromPatch(const GatherSolution& solution, const trace::SceneTracer& tracer, const RayOrigin& from, const RayNumbers& numbers) {
    const auto met = chosenPoint(solution.guide, tracer, from, numbers.which(), numbers.where());
    if (!met) return {};
    return {met->share * sentFrom(met->point, met->distance, solution, tracer, numbers).radiosity, met->distance};
}

Brought fromOpening(const GatherSolution& solution, const trace::SceneTracer& tracer, const RayOrigin& from, const RayNumbers& numbers) {
    const Openings::Choice chosen = solution.openings.choose(numbers.which(), numbers.where());
    const auto aim = aimAt(chosen.positionWorld, chosen.inward, tracer, from);
    if (!aim || tracer.nextPoint(from.point, aim->direction)) return {};
    const double density = densityOfDirection(solution.openings.density(), aim->distance, aim->cosineThere);
    return {balanced(density, aim->cosineHere / glm::pi<double>()) * aim->cosineHere / density * solution.outside, aim->distance};
}

/// The share of what comes in along a ray in any direction that counts where rays to openings may find it, too.
double shareOfOutside(const Openings& openings, const dvec3& fromWorld, const dvec3& direction, double cosineHere) {
    const auto exit = openings.exit(fromWorld, direction);
    if (!exit) return 1;
    return balanced(cosineHere / glm::pi<double>(), densityOfDirection(openings.density(), exit->distance, exit->cosine));
}

/// On which patch the point lies, if from there points are chosen.
std::optional<std::uint32_t> unevenPatch(const trace::SurfacePoint& point, const GatherSolution& solution, const trace::SceneTracer& tracer) {
    const auto patch = patchOf(point, solution.cache.cells(), tracer);
    return patch && solution.guide.isUneven(*patch) ? patch : std::nullopt;
}

} // namespace

// [anchor: final-gather]
Gathered gather(const GatherSolution& solution, const PixelLight& light, ivec2 pixel, const GatherRays& rays) {
    const trace::SceneTracer& tracer = light.tracer();
    const trace::SurfacePoint& point = light.pointAt(pixel);
    const RayOrigin origin{point, light.normalWorld(point), geometricNormal(tracer, point), unevenPatch(point, solution, tracer)};
    const dvec3 from = tracer.positionCentred(point);
    CosineDirections directions(origin.normal, rays.shift, rays.first);
    const bool asksOpenings = !solution.openings.isEmpty() && solution.openings.surround(tracer.positionWorld(point));
    Gathered sum;
    for (std::size_t i = rays.first; i < rays.first + rays.count; ++i) {
        const dvec3 leaning = directions.next();
        const double cosine = glm::dot(leaning, origin.normal);
        const RayNumbers numbers(i, rays.shift);
        // A smooth normal leans: what would go through the surface is turned back to its side. (Simplified: near the rim of a round
        // body some directions then count twice, and others not at all.)
        const dvec3 direction = leaning - 2 * std::min(0.0, glm::dot(leaning, origin.flat)) * origin.flat;
        const trace::SurfacePoint met = tracer.nextPoint(from, point.primitive, direction);
        // A surface that sends B all over the half sphere brings B.
        if (met) {
            const double distance = std::max(glm::distance(from, tracer.positionCentred(met)), kContactDistance);
            sum.nearness += 1 / distance;
            ++sum.met;
            const Sent sent = sentFrom(met, distance, solution, tracer, numbers);
            sum.irradiance += shareByChance(solution.guide, tracer, origin, direction, met, sent.patch, distance) * sent.radiosity;
        } else {
            const double share = asksOpenings ? shareOfOutside(solution.openings, tracer.positionWorld(point), direction, cosine) : 1;
            sum.irradiance += share * glm::pi<double>() * solution.outside;
        }
        if (origin.patch) addTo(sum, fromPatch(solution, tracer, origin, numbers));
        if (asksOpenings) addTo(sum, fromOpening(solution, tracer, origin, numbers));
    }
    return sum;
}

} // namespace shadowlab::radiosity
