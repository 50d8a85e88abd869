// SPDX-License-Identifier: MIT
#include "app/lab/dragging.h"

#include <algorithm>
#include <cmath>

#include "app/lab/camera_control.h"

namespace shadowlab::lab {

namespace {

/// Sine of the smallest angle between the eye's ray and the ground at which a thing is dragged over the ground: five
/// degrees for what stands there. A lamp hangs free, and follows the mouse better in the plane of the picture below twelve.
constexpr double kObjectLevel = 0.08, kLightLevel = 0.2;
/// A thing moves at most that many times as far as the mouse seems to move at its depth: near the horizon a pixel is a very long way.
constexpr double kFarthestStep = 12;
constexpr double kStepPixels = 4;  ///< the mouse's way is followed in steps of that length,
constexpr int kMostSteps = 64;     ///< or in that many
constexpr double kLargestGain = 8; ///< of a light far outside the picture
constexpr double kLeastDepth = Hold().leastDepth;

double heightPerDepth(const scene::Camera& camera) { return 2 * std::tan(glm::radians(camera.fovYDegrees) / 2); }

/// What a pixel measures at the depth of a point, in a plane that faces the eye. Metres.
double metresPerPixel(const scene::Camera& camera, ivec2 size, const dvec3& positionWorld, double leastDepth = kLeastDepth) {
    const PictureAxes axes = pictureAxes(camera);
    const double depth = std::abs(glm::dot(positionWorld - camera.positionWorld, axes.forwardWorld));
    const double least = leastDepth * glm::length(camera.targetWorld - camera.positionWorld);
    return std::max(depth, least) * heightPerDepth(camera) / size.y;
}

/// How many pixels a point moves, x to the right and y down, for each metre that it goes in that direction.
dvec2 pixelsPerMetre(const scene::Camera& camera, ivec2 size, const dvec3& positionWorld, const dvec3& directionWorld) {
    const PictureAxes axes = pictureAxes(camera);
    const dvec3 fromEyeWorld = positionWorld - camera.positionWorld;
    const auto inView = [&](const dvec3& v) {
        return dvec3(glm::dot(v, axes.rightWorld), -glm::dot(v, axes.upWorld), glm::dot(v, axes.forwardWorld));
    };
    const dvec3 place = inView(fromEyeWorld), way = inView(directionWorld);
    const double least = kLeastDepth * glm::length(camera.targetWorld - camera.positionWorld);
    const double depth = std::max(place.z, least);
    // The derivative of (x / depth, y / depth).
    return dvec2(way.x * depth - place.x * way.z, way.y * depth - place.y * way.z) *
           (size.y / (heightPerDepth(camera) * depth * depth));
}

dvec3 noLongerThan(const dvec3& v, double longest) {
    const double length = glm::length(v);
    return length > longest ? v * (longest / length) : v;
}

/// A step along one direction. Where the eye looks along it, up counts as the mouse's way up.
dvec3 stepAlong(const scene::Camera& camera, ivec2 size, const dvec3& gripWorld, const dvec3& directionWorld,
                const dvec2& byPixels) {
    const double metres = metresPerPixel(camera, size, gripWorld);
    const dvec2 seen = pixelsPerMetre(camera, size, gripWorld, directionWorld);
    const double lengthSquared = glm::dot(seen, seen);
    const double foreshortening = metres * std::sqrt(lengthSquared); // 1 in a plane that faces the eye
    if (foreshortening < 1 / kFarthestStep) return -byPixels.y * metres * directionWorld;
    return glm::dot(byPixels, seen) / lengthSquared * directionWorld;
}

/// A step over the ground that moves the grip by so many pixels, if that is not too far.
dvec3 stepLevel(const scene::Camera& camera, ivec2 size, const dvec3& gripWorld, const dvec2& byPixels) {
    const dvec3 upWorld = glm::normalize(camera.upWorld);
    const dvec3 acrossWorld = pictureAxes(camera).rightWorld, awayWorld = glm::cross(upWorld, acrossWorld);
    const dvec2 across = pixelsPerMetre(camera, size, gripWorld, acrossWorld),
                away = pixelsPerMetre(camera, size, gripWorld, awayWorld);
    const double area = across.x * away.y - across.y * away.x; // of the picture of a square metre of ground
    const double metres = metresPerPixel(camera, size, gripWorld);
    const double longest = kFarthestStep * metres * glm::length(byPixels);
    if (std::abs(area) * metres * metres < 1e-6) return byPixels.x * metres * acrossWorld;
    const double right = (byPixels.x * away.y - byPixels.y * away.x) / area,
                 forward = (across.x * byPixels.y - across.y * byPixels.x) / area;
    return noLongerThan(right * acrossWorld + forward * awayWorld, longest);
}

/// A directional light turns about the camera's target, always by the same angle for a pixel. Its place n on the ball around the target
/// goes the way d of the mouse as it does in the stereographic picture of the ball, whose middle m is the pole toward the eye, or, of a
/// far side, the pole away from it: d is turned with the shortest turn that brings m to n. So its way is never against the mouse before
/// the edge of the ball, goes on behind the edge, and nowhere is there an axis about which nothing moves.
dvec3 stepTurn(const Hold& hold, const scene::Camera& camera, ivec2 size, const dvec3& placeWorld, const dvec2& byPixels) {
    const double pixels = glm::length(byPixels);
    if (pixels == 0) return dvec3(0.0);
    const PictureAxes axes = pictureAxes(camera);
    const dvec3 toLightWorld = placeWorld - camera.targetWorld;
    const dvec3 n = glm::normalize(toLightWorld), m = -hold.side * axes.forwardWorld;
    const dvec3 d = (byPixels.x * axes.rightWorld - byPixels.y * axes.upWorld) / pixels;
    const double onePlusCosine = std::max(1 + glm::dot(m, n), 1e-12); // zero at the other pole, where every turn is as short
    const dvec3 way = glm::normalize(d - glm::dot(d, n) / onePlusCosine * (m + n));
    const double radians = pixels * heightPerDepth(camera) / size.y;
    return glm::length(toLightWorld) * (std::cos(radians) * n + std::sin(radians) * way) - toLightWorld;
}

dvec3 step(const Hold& hold, const scene::Camera& camera, ivec2 size, const dvec3& placeWorld, const dvec2& byPixels) {
    const dvec3 gripWorld = placeWorld + hold.gripFromPlaceWorld;
    switch (hold.way) {
    case DragWay::level: return stepLevel(camera, size, gripWorld, byPixels);
    case DragWay::upright: return stepAlong(camera, size, gripWorld, glm::normalize(camera.upWorld), byPixels);
    case DragWay::alongX: return stepAlong(camera, size, gripWorld, {1, 0, 0}, byPixels);
    case DragWay::alongY: return stepAlong(camera, size, gripWorld, {0, 1, 0}, byPixels);
    case DragWay::alongZ: return stepAlong(camera, size, gripWorld, {0, 0, 1}, byPixels);
    case DragWay::turn: return stepTurn(hold, camera, size, placeWorld, byPixels);
    case DragWay::picture: break;
    }
    const PictureAxes axes = pictureAxes(camera);
    return hold.gain * metresPerPixel(camera, size, gripWorld, hold.leastDepth) *
           (byPixels.x * axes.rightWorld - byPixels.y * axes.upWorld);
}

} // namespace

Hold holdOf(const scene::Camera& camera, ivec2 size, const scene::Scene& scene, const Handle& handle, const dvec3& gripWorld,
            const std::optional<dvec2>& markPixel) {
    Hold hold;
    const bool light = handle.what.kind == Selection::Kind::light;
    if (light && scene.light(handle.what.index).type == scene::LightType::directional) {
        hold.way = DragWay::turn;
        const dvec3 viewWorld = camera.targetWorld - camera.positionWorld;
        hold.side = glm::dot(handle.positionWorld - camera.targetWorld, viewWorld) <= 0 ? 1 : -1;
        return hold;
    }
    if (markPixel) {
        // A lamp beside the eye, or behind it, moves as what is looked at does: at its own depth a pixel would be next to nothing.
        const dvec3 viewWorld = camera.targetWorld - camera.positionWorld;
        if (glm::dot(handle.positionWorld - camera.positionWorld, viewWorld) < glm::dot(viewWorld, viewWorld)) {
            hold.leastDepth = 1;
            return hold;
        }
        // The way from the mark to the picture's middle leads the thing there, too.
        const dvec2 middle = 0.5 * dvec2(size);
        if (const auto pixel = pixelOf(camera, size, handle.positionWorld))
            hold.gain = std::clamp(glm::length(*pixel - middle) / std::max(1.0, glm::length(*markPixel - middle)), 1.0,
                                   kLargestGain);
        return hold;
    }
    hold.gripFromPlaceWorld = gripWorld - handle.positionWorld;
    const dvec3 rayWorld = glm::normalize(gripWorld - camera.positionWorld);
    const double sine = std::abs(glm::dot(rayWorld, glm::normalize(camera.upWorld)));
    hold.way = sine >= (light ? kLightLevel : kObjectLevel) ? DragWay::level : DragWay::picture;
    return hold;
}

dvec3 draggedBy(const Hold& hold, const scene::Camera& camera, ivec2 size, const dvec3& placeWorld, const dvec2& byPixels) {
    const int steps = std::clamp(static_cast<int>(std::ceil(glm::length(byPixels) / kStepPixels)), 1, kMostSteps);
    dvec3 movedWorld(0.0);
    for (int i = 0; i < steps; ++i)
        movedWorld += step(hold, camera, size, placeWorld + movedWorld, byPixels / static_cast<double>(steps));
    return movedWorld;
}

} // namespace shadowlab::lab
