// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/ray_end.h"

#include <array>
#include <cmath>
#include <optional>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/query/shading.h"
#include "techniques/radiosity/display/aimed_rays.h"

namespace shadowlab::radiosity {

namespace {

// A ray goes on where it is shorter than so many edges of the patch. From farther away the patch looks small, and the rays around it end on others. With two
// edges a picture takes up to a tenth longer, and blocks of 8 x 8 pixels come from 0.1 to 0.4 % to 0.1 % of those of 5000 patches.
constexpr double kNear = 1;

/// What one ray finds.
class RayEnd {
public:
    RayEnd(const GatherSolution& solution, const trace::SceneTracer& tracer, const RayNumbers& numbers)
        : solution_(solution), tracer_(tracer), numbers_(numbers) {}

    [[nodiscard]] Sent sentFrom(const trace::SurfacePoint& point, double distance, int reflections) const {
        // What a lamp sends is direct light, which has been counted.
        if (tracer_.objectOf(point).emitterOfLight >= 0) return {};
        const auto patch = patchOf(point, solution_.cache.cells(), tracer_);
        if (!patch) return {}; // the inside of a closed body: dark
        const dvec3 emission = emittedAt(tracer_, point), reflectance = reflectanceAt(tracer_, point);
        dvec3 irradiance = !goesOn(*patch, distance, reflections) ? reflectedAt(point, *patch)
                                                                   : onward(point, *patch, reflections, chanceToGoOn(reflectance, emission, *patch));
        for (int i = 0; i < static_cast<int>(tracer_.scene().lights.size()); ++i) {
            const scene::Light& source = tracer_.scene().light(i);
            if (scene::hasArea(source))
                irradiance += fromLamp(point, i, *patch);
            else if (isLit(point, i, *patch))
                irradiance += scene::irradiance(source, tracer_.positionWorld(point), geometricNormal(tracer_, point));
        }
        return {emission + reflectance * irradiance, patch};
    }

private:
    /// Simplified: where openings bring much of the light, only rays sent to them on purpose find it without noise, and the patch's mean is kept.
    [[nodiscard]] bool goesOn(std::uint32_t patch, double distance, int reflections) const {
        if (reflections == kMostReflections) return false;
        const bool isNear = distance * distance < kNear * kNear * solution_.cache.room().allPatches()[patch].area;
        return isInGapWithoutCells(patch) || (isNear && solution_.openings.isEmpty());
    }

    /// The irradiance by other surfaces, W/m^2: the patch's mean, and of what is followed along paths that of the place.
    [[nodiscard]] dvec3 reflectedAt(const trace::SurfacePoint& point, std::uint32_t patch) const {
        const dvec3 mean = solution_.reflectedIrradiance[patch];
        const PathLight& paths = solution_.cache.pathLight();
        if (!paths.hasCells(patch)) return mean;
        const dvec3 at = tracer_.positionWorld(point) - solution_.cache.room().world().originWorld;
        return glm::max(dvec3(0), mean - solution_.sources.byPaths[patch]) + paths.at(patch, at);
    }

    /// Of a mesh that was simplified, patches in a gap know nothing of the place, and what faces the gap is far brighter than what does not.
    [[nodiscard]] bool isInGapWithoutCells(std::uint32_t patch) const {
        return solution_.cache.isFollowed(patch) && !solution_.cache.pathLight().hasCells(patch);
    }

    /// How often a ray goes on from there: always, but on a lamp, of which most is its own light, as often as the share that it reflects. A picture with a ball that glows
    /// would take half as long again for the little that it reflects.
    [[nodiscard]] double chanceToGoOn(const dvec3& reflectance, const dvec3& emission, std::uint32_t patch) const {
        constexpr double kLeast = 0.05; // the mean may be too small
        if (emission == dvec3(0) || !isInGapWithoutCells(patch)) return 1;
        const double reflected = luminance(reflectance * solution_.reflectedIrradiance[patch]);
        return std::max(kLeast, reflected / (reflected + luminance(emission)));
    }

    /// The same as one ray finds it that goes on with that chance: where light comes from few patches, in half of all cases a ray to a point of them.
    [[nodiscard]] dvec3 onward(const trace::SurfacePoint& point, std::uint32_t patch, int reflections, double chance) const {
        const double which = numbers_.onwardWhich(reflections) / chance;
        return which < 1 ? irradianceBy(which, point, patch, reflections) / chance : dvec3(0);
    }
    [[nodiscard]] dvec3 irradianceBy(double which, const trace::SurfacePoint& point, std::uint32_t patch, int reflections) const {
        const dvec3 normal = geometricNormal(tracer_, point);
        const bool mayChoose = solution_.guide.isUneven(patch);
        const RayOrigin from{point, normal, normal, mayChoose ? std::optional(patch) : std::nullopt};
        const double ofKinds = mayChoose ? 2 : 1;
        if (mayChoose && which < 0.5) {
            const auto met = chosenPoint(solution_.guide, tracer_, from, ofKinds * which, numbers_.onward(reflections));
            return met ? ofKinds * met->share * sentFrom(met->point, met->distance, reflections + 1).radiosity : dvec3(0);
        }
        const dvec3 direction = diffuseDirection(tracer_, point, numbers_.onward(reflections));
        const trace::SurfacePoint met = tracer_.nextPoint(point, direction);
        if (!met) return ofKinds * glm::pi<double>() * solution_.outside;
        const double distance = glm::distance(tracer_.positionCentred(point), tracer_.positionCentred(met));
        const Sent sent = sentFrom(met, distance, reflections + 1);
        return ofKinds * shareByChance(solution_.guide, tracer_, from, direction, met, sent.patch, distance) * sent.radiosity;
    }

    /// May a shadow end on the patch? Where it is one of a simplified mesh, and the place lies beside it, it does not know that of the place.
    [[nodiscard]] bool mayHaveEdge(const trace::SurfacePoint& point, const DirectLight& light, std::size_t patch) const {
        if (light.mayHaveEdge[patch] != 0) return true;
        const Room& room = solution_.cache.room();
        if (!room.isSimplified(tracer_.world().objects[point.primitive])) return false;
        const Patch& one = room.allPatches()[patch];
        return !holds(one.polygon, tracer_.positionWorld(point) - room.world().originWorld, one.normal);
    }

    /// Does a light without an area arrive there? Where nothing stands before the patch, or something hides all of it, no ray is needed.
    [[nodiscard]] bool isLit(const trace::SurfacePoint& point, int number, std::size_t patch) const {
        const DirectLight& light = solution_.cache.light(number);
        if (mayHaveEdge(point, light, patch)) return tracer_.visibility(point, number) == trace::Visibility::lit;
        return light.visible[patch] > 0 && scene::lightShinesTo(tracer_.scene().light(number), tracer_.positionWorld(point));
    }

    /// What a light with an area brings, W/m^2: without shadows by its closed form, and the share of it that arrives by a few lines to places spread over it.
    [[nodiscard]] dvec3 fromLamp(const trace::SurfacePoint& point, int number, std::size_t patch) const {
        // Where lines found a penumbra on the patch; elsewhere nearly all have the same answer.
        constexpr int kLinesInPenumbra = 4;
        const DirectLight& light = solution_.cache.light(number);
        const double visible = light.visible[patch];
        const bool needsRays = mayHaveEdge(point, light, patch);
        if (!needsRays && visible == 0) return dvec3(0);
        const LightSource& source = solution_.cache.source(number);
        const dvec3 at = tracer_.positionWorld(point) - solution_.cache.room().world().originWorld, normal = geometricNormal(tracer_, point);
        const dvec3 whole = source.irradiance(at, normal) * source.color();
        if (!needsRays || whole == dvec3(0)) return whole;
        const int lines = visible > 0 && visible < 1 ? kLinesInPenumbra : 1;
        const dvec2 onLight = numbers_.onLight();
        double free = 0, all = 0;
        for (int i = 0; i < lines; ++i) {
            const LightLine line = source.line(at, normal, (i + onLight.x) / lines, glm::fract(onLight.y + i * kGolden));
            const trace::Ray ray{tracer_.positionCentred(point), line.fromCentred - at, trace::kContact, 1 - trace::kContact};
            all += line.weight;
            free += line.weight > 0 && !tracer_.isBlocked(ray, point.primitive, number) ? line.weight : 0;
        }
        return (all > 0 ? free / all : visible) * whole;
    }

    const GatherSolution& solution_;
    const trace::SceneTracer& tracer_;
    const RayNumbers& numbers_;
};

} // namespace

Sent sentFrom(const trace::SurfacePoint& point, double distance, const GatherSolution& solution, const trace::SceneTracer& tracer, const RayNumbers& numbers) {
    return RayEnd(solution, tracer, numbers).sentFrom(point, distance, 0);
}

} // namespace shadowlab::radiosity
