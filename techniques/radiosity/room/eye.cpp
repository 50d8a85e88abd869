// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/eye.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/math/perpendicular.h"

namespace shadowlab::radiosity {

namespace {

// Steps of the place, as a share of the size of the scene. A film that goes round it by one degree for each picture takes a step in every fifth.
constexpr double kPlaceStep = 1.0 / 16;
// Steps of each component of the view's direction, which has length 1.
constexpr double kDirectionStep = 1.0 / 4;
// So far a direction may be from the one that stands for it: half a step in each of three components. The picture is widened by as much on each side.
const double kTurn = glm::degrees(0.5 * kDirectionStep * glm::root_three<double>());
// Wider pictures are nearly all of what lies before the eye.
constexpr double kWidest = 150;

// No surface is met on the way to the place that stands for it, nor so much farther, so that the place does not lie on one.
constexpr double kClear = 1.25;

dvec3 rounded(const dvec3& value, double step) { return step * glm::round(value / step); }

} // namespace

Eye inSteps(const Eye& eye, const trace::CentredBox& scene, const trace::SceneTracer& tracer) {
    const double longest = glm::distance(scene.lower, scene.upper);
    if (!(longest > 0) || !std::isfinite(longest)) return eye; // there is nothing to see
    const dvec3 firstWorld = tracer.world().originWorld + scene.lower;
    Eye result = eye;
    scene::Camera& camera = result.camera;
    const dvec3 &eyeWorld = eye.camera.positionWorld, placeWorld = firstWorld + rounded(eyeWorld - firstWorld, kPlaceStep * longest);
    const double distance = glm::distance(eyeWorld, placeWorld);
    if (distance > 0) {
        const trace::SurfacePoint between = tracer.nextPoint(eyeWorld - tracer.world().originWorld, trace::kNoPrimitive, (placeWorld - eyeWorld) / distance);
        if (!between || glm::distance(tracer.positionWorld(between), eyeWorld) > kClear * distance) camera.positionWorld = placeWorld;
    }
    const dvec3 directionWorld = glm::normalize(rounded(glm::normalize(eye.camera.targetWorld - eyeWorld), kDirectionStep));
    camera.targetWorld = camera.positionWorld + directionWorld;
    if (!scene::hasView(camera)) camera.upWorld = perpendicularTo(directionWorld);
    camera.fovYDegrees = std::max(camera.fovYDegrees, std::min(kWidest, camera.fovYDegrees + 2 * kTurn));
    return result;
}

} // namespace shadowlab::radiosity
