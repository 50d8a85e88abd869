// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/gather_rays.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/math/perpendicular.h"
#include "techniques/radiosity/display/ray_end.h"

namespace shadowlab::radiosity {

namespace {

// Nearer than that is contact, metres.
constexpr double kLeastDistance = 1e-9;

// A ray that ends before this share of its way is lacking has arrived: meshes are rounded to floats.
constexpr double kSamePlace = 1e-5;

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

/// The share of what is found in a direction that counts where two kinds of rays may find it, this one and another.
double balanced(double density, double densityOfOther) { return density > 0 ? density / (density + densityOfOther) : 0; }

/// The density of a direction, 1/sr, in which one sees the point, from that of the point on its surface.
double densityOfDirection(double density, double distance, double cosineThere) {
    return density * distance * distance / std::max(cosineThere, 1e-9);
}

/// What a ray to a chosen point of an emitter or an opening brings.
struct Brought {
    dvec3 irradiance{0.0}; ///< W/m^2
    double distance = 1;   ///< metres
};
void addTo(Gathered& sum, const Brought& brought) {
    sum.irradiance += brought.irradiance;
    sum.fromEmitters += luminance(brought.irradiance);
    sum.nearnessOfEmitters += luminance(brought.irradiance) / brought.distance;
}

/// A ray to a chosen point.
struct Aim {
    dvec3 direction{0.0};
    double distance = 0, cosineHere = 0, cosineThere = 0;
};
/// `facing`: of the surface there, toward those who see it. Nothing: they do not face each other.
std::optional<Aim> aimAt(const dvec3& positionWorld, const dvec3& facing, const trace::SceneTracer& tracer, const trace::SurfacePoint& point,
                         const dvec3& normal) {
    const dvec3 way = positionWorld - tracer.positionWorld(point);
    const double distance = glm::length(way);
    if (!(distance > kLeastDistance)) return std::nullopt;
    const dvec3 direction = way / distance;
    const Aim aim{direction, distance, glm::dot(direction, normal), -glm::dot(direction, facing)};
    if (aim.cosineHere <= 0 || aim.cosineThere <= 0 || glm::dot(direction, geometricNormal(tracer, point)) <= 0) return std::nullopt;
    return aim;
}

Brought fromEmitter(const GatherSolution& solution, const trace::SceneTracer& tracer, const trace::SurfacePoint& point, const dvec3& normal,
                    const Emitters::Choice& chosen) {
    const auto aim = aimAt(chosen.positionWorld, chosen.normal, tracer, point, normal);
    if (!aim) return {};
    const trace::SurfacePoint met = tracer.nextPoint(point, aim->direction);
    if (!met || glm::distance(tracer.positionWorld(met), tracer.positionWorld(point)) < (1 - kSamePlace) * aim->distance) return {};
    const double byChoice = densityOfDirection(solution.emitters.density(chosen.patch), aim->distance, aim->cosineThere);
    const double weight = balanced(byChoice, aim->cosineHere / glm::pi<double>());
    const double density = densityOfDirection(chosen.density, aim->distance, aim->cosineThere);
    return {weight * aim->cosineHere / (glm::pi<double>() * density) * solution.sources.emission[chosen.patch], aim->distance};
}

Brought fromOpening(const GatherSolution& solution, const trace::SceneTracer& tracer, const trace::SurfacePoint& point, const dvec3& normal,
                    const Openings::Choice& chosen) {
    const auto aim = aimAt(chosen.positionWorld, chosen.inward, tracer, point, normal);
    if (!aim || tracer.nextPoint(point, aim->direction)) return {};
    const double density = densityOfDirection(solution.openings.density(), aim->distance, aim->cosineThere);
    return {balanced(density, aim->cosineHere / glm::pi<double>()) * aim->cosineHere / density * solution.outside, aim->distance};
}

/// The share of what comes in along a ray in any direction that counts where rays to openings may find it, too.
double shareOfOutside(const Openings& openings, const dvec3& fromWorld, const dvec3& direction, double cosineHere) {
    const auto exit = openings.exit(fromWorld, direction);
    if (!exit) return 1;
    return balanced(cosineHere / glm::pi<double>(), densityOfDirection(openings.density(), exit->distance, exit->cosine));
}

} // namespace

// [anchor: final-gather]
Gathered gather(const GatherSolution& solution, const PixelLight& light, ivec2 pixel, const GatherRays& rays) {
    const trace::SurfacePoint& point = light.pointAt(pixel);
    const trace::SceneTracer& tracer = light.tracer();
    const dvec3 from = tracer.positionCentred(point), normal = light.normalWorld(point), flat = geometricNormal(tracer, point);
    const dvec2& shift = rays.shift;
    CosineDirections directions(normal, shift, rays.first);
    const bool asksOpenings = !solution.openings.isEmpty() && solution.openings.surround(tracer.positionWorld(point));
    Gathered sum;
    for (std::size_t i = rays.first; i < rays.first + rays.count; ++i) {
        const dvec3 leaning = directions.next();
        const RayNumbers numbers(i, shift);
        // A smooth normal leans: what would go through the surface is turned back to its side. (Simplified: near the rim of a round
        // body some directions then count twice, and others not at all.)
        const dvec3 direction = leaning - 2 * std::min(0.0, glm::dot(leaning, flat)) * flat;
        const trace::SurfacePoint met = tracer.nextPoint(from, point.primitive, direction);
        // A surface that sends B all over the half sphere brings B.
        if (met) {
            const double distance = std::max(glm::distance(from, tracer.positionCentred(met)), kLeastDistance);
            sum.nearness += 1 / distance;
            ++sum.met;
            const Sent sent = sentFrom(met, distance, solution, tracer, numbers);
            sum.irradiance += sent.reflected;
            if (sent.density > 0) { // rays are sent there on purpose as well
                const double other = densityOfDirection(sent.density, distance, -glm::dot(direction, geometricNormal(tracer, met)));
                sum.irradiance += balanced(glm::dot(leaning, normal) / glm::pi<double>(), other) * sent.emitted;
            } else {
                sum.irradiance += sent.emitted;
            }
        } else {
            const double share = asksOpenings ? shareOfOutside(solution.openings, tracer.positionWorld(point), direction, glm::dot(leaning, normal)) : 1;
            sum.irradiance += share * glm::pi<double>() * solution.outside;
        }
        if (!solution.emitters.isEmpty())
            addTo(sum, fromEmitter(solution, tracer, point, normal, solution.emitters.choose(numbers.which(), numbers.where())));
        if (asksOpenings) addTo(sum, fromOpening(solution, tracer, point, normal, solution.openings.choose(numbers.which(), numbers.where())));
    }
    return sum;
}

} // namespace shadowlab::radiosity
