// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/outside_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/model/object_pieces.h"

namespace shadowlab::scene {

namespace {

// An object thinner than this share of its longest side is flat: a wall of 5 cm in a room of 5 m is.
constexpr double kFlatShare = 0.01;
// A flat object is background (a floor, a wall) if it is this many times as large as everything that is not flat.
constexpr double kStageTimes = 1.5;
// Lights farther away than this many times the size of objects and eye together are left out of the picture, because
// showing them would make everything else too small.
constexpr double kNearLights = 4;

constexpr double kEndOn = 0.8;    ///< cosine: an arrow within 37 degrees of the line of sight looks like a dot
constexpr double kAgainst = -0.2; ///< cosine: light that travels clearly toward the camera

constexpr double kFovYDegrees = 40;
constexpr double kFilled = 0.85; ///< of the picture's half width and height: the rest is margin
// The near plane, as a share of the distance to the nearest point, because lines may come nearer than all points. Depth
// steps at distance D are D^2 / (near 2^24), with this share not more than a few hundred-thousandths of D, a fraction of a
// pixel.
constexpr double kNearShare = 1.0 / 100;

double size(const Bounds& box) { return box.isEmpty() ? 0.0 : glm::length(box.upperWorld - box.lowerWorld); }
dvec3 middle(const Bounds& box) { return 0.5 * (box.lowerWorld + box.upperWorld); }

bool isFlat(const Bounds& box) {
    const dvec3 extent = box.upperWorld - box.lowerWorld;
    return std::min({extent.x, extent.y, extent.z}) <= kFlatShare * std::max({extent.x, extent.y, extent.z});
}

/// A piece of a mesh that lies, or reaches, more than a thousand sizes of the first piece away from it: the rest would be a dot.
bool isFarPiece(const Scene& scene, const std::vector<Bounds>& boxes, std::size_t object) {
    constexpr double kFarInSizes = 1000; // as for the vertices of a mesh (obj/outliers.h)
    const Bounds &first = boxes[piecesOf(scene, object).first], &box = boxes[object];
    const dvec3 beyond = glm::max(first.lowerWorld - box.lowerWorld, box.upperWorld - first.upperWorld);
    return std::max({beyond.x, beyond.y, beyond.z}) > kFarInSizes * size(first);
}

/// True if the segment from a to b enters the box; false if an end lies in it (slab test: Kay and Kajiya, 1986).
bool isBetween(const Bounds& box, const dvec3& a, const dvec3& b) {
    double enter = 0, leave = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double way = b[axis] - a[axis];
        if (way == 0) {
            if (a[axis] < box.lowerWorld[axis] || a[axis] > box.upperWorld[axis]) return false;
            continue;
        }
        const double first = (box.lowerWorld[axis] - a[axis]) / way, second = (box.upperWorld[axis] - a[axis]) / way;
        enter = std::max(enter, std::min(first, second));
        leave = std::min(leave, std::max(first, second));
    }
    return enter <= leave && enter > 0 && leave < 1;
}

/// Axes of a camera that looks at the eye's scene from `asideDegrees` beside the eye and `aboveDegrees` above.
struct Axes {
    dvec3 right, up, backward;
};
Axes axesBeside(const Camera& eye, double asideDegrees, double aboveDegrees) {
    const double aside = glm::radians(asideDegrees), above = glm::radians(aboveDegrees);
    const dvec3 up = glm::normalize(eye.upWorld);
    const dvec3 backwardOfEye = glm::normalize(eye.positionWorld - eye.targetWorld);
    const dvec3 right = glm::normalize(glm::cross(up, backwardOfEye)); // hasView: they are not parallel
    const dvec3 behind = glm::cross(right, up);
    Axes axes;
    axes.backward = std::cos(above) * (std::cos(aside) * behind + std::sin(aside) * right) + std::sin(above) * up;
    axes.right = glm::normalize(glm::cross(up, axes.backward));
    axes.up = glm::cross(axes.backward, axes.right);
    return axes;
}

/// As near as possible, all points within the filled part of the picture. Seen from c + D backward, a point at (x, toward)
/// is within when |x - c| <= tan * (D - toward): of the two conditions each has one point that is hardest to meet, and the
/// camera stands where both of these are just met. Across and up alike; the larger distance is taken.
Camera framing(const std::vector<dvec3>& pointsWorld, const Axes& axes, const dvec3& upWorld, double aspect) {
    const double tanUp = kFilled * std::tan(glm::radians(kFovYDegrees / 2)), tanRight = tanUp * aspect;
    const double none = -std::numeric_limits<double>::infinity();
    double right = none, left = none, up = none, down = none, nearest = none, farthest = -none;
    for (const dvec3& p : pointsWorld) {
        const dvec3 offset = p - pointsWorld.front(); // so nothing is lost far from the origin
        const double x = glm::dot(offset, axes.right), y = glm::dot(offset, axes.up);
        const double toward = glm::dot(offset, axes.backward);
        right = std::max(right, tanRight * toward + x);
        left = std::max(left, tanRight * toward - x);
        up = std::max(up, tanUp * toward + y);
        down = std::max(down, tanUp * toward - y);
        nearest = std::max(nearest, toward);
        farthest = std::min(farthest, toward);
    }
    const double back = std::max((right + left) / (2 * tanRight), (up + down) / (2 * tanUp));
    const dvec3 middle = pointsWorld.front() + 0.5 * (right - left) * axes.right + 0.5 * (up - down) * axes.up;
    Camera camera;
    camera.positionWorld = middle + back * axes.backward;
    camera.targetWorld = middle + 0.5 * (nearest + farthest) * axes.backward; // in their middle: the camera orbits it
    camera.upWorld = upWorld;
    camera.fovYDegrees = kFovYDegrees;
    camera.near = kNearShare * (back - nearest);
    return camera;
}

/// What the second camera has to show.
struct Subject {
    std::vector<dvec3> framed;  ///< points within its picture
    std::vector<dvec3> seen;    ///< points that nothing should hide: the eye, the middle of the things, the lights
    std::vector<dvec3> arrows;  ///< unit: directions of light that comes from no place
    std::vector<dvec3> shining; ///< unit: the ways light travels where the things are
};

Subject subjectOf(const Scene& scene, const Bounds& things, const Camera& eye, double aspect) {
    const dvec3 centre = things.isEmpty() ? eye.targetWorld : middle(things);
    Subject subject;
    subject.seen = subject.framed = {eye.positionWorld, centre};
    for (int i = 0; i < 8 && !things.isEmpty(); ++i)
        subject.framed.push_back(things.corner(i));
    // Of the eye's view, what it has where the things are; all of it may be far larger than they.
    for (const dvec3& corner : viewCorners(eye, aspect, glm::length(centre - eye.positionWorld)))
        subject.framed.push_back(corner);
    Bounds all = things;
    all.include(centre);
    all.include(eye.positionWorld);
    for (const Light& light : scene.lights) {
        dvec3 place = light.positionWorld;
        if (light.type == LightType::directional) {
            const ArrowPlace arrow = arrowPlace(things, light);
            place = arrow.tipWorld - arrow.length * light.directionWorld;
            subject.arrows.push_back(light.directionWorld);
            for (int axis = 0; axis < 3; ++axis) // those around the middle one
                for (const double side : {-arrow.spread, arrow.spread}) {
                    subject.framed.push_back(place);
                    subject.framed.back()[axis] += side;
                }
        }
        if (glm::length(place - middle(all)) > kNearLights * size(all)) continue;
        subject.framed.push_back(place);
        subject.seen.push_back(place);
        if (place != centre)
            subject.shining.push_back(light.type == LightType::directional ? light.directionWorld
                                                                           : glm::normalize(centre - place));
    }
    return subject;
}

/// The penalty of a camera position: hidden points, arrows seen end-on, and at half the weight dark sides that face the
/// camera, because the light comes from behind.
double faultsOf(const Camera& camera, const Subject& subject, const std::vector<Bounds>& boxes) {
    double faults = 0;
    for (const dvec3& point : subject.seen)
        faults += std::ranges::any_of(
            boxes, [&](const Bounds& box) { return !box.isEmpty() && isBetween(box, camera.positionWorld, point); });
    const dvec3 forward = glm::normalize(camera.targetWorld - camera.positionWorld);
    for (const dvec3& direction : subject.arrows)
        faults += std::abs(glm::dot(direction, forward)) > kEndOn;
    for (const dvec3& direction : subject.shining)
        faults += 0.5 * (glm::dot(direction, forward) < kAgainst);
    return faults;
}

} // namespace

Bounds thingsBounds(const Scene& scene) {
    std::vector<Bounds> boxes = objectBounds(scene);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (scene.objects[i].isFurtherPiece && isFarPiece(scene, boxes, i)) boxes[i] = {};
    Bounds all, solid;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (scene.objects[i].emitterOfLight >= 0 || boxes[i].isEmpty()) continue;
        all.include(boxes[i]);
        if (!isFlat(boxes[i])) solid.include(boxes[i]);
    }
    if (solid.isEmpty()) return all;
    Bounds things = solid;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (scene.objects[i].emitterOfLight < 0 && !boxes[i].isEmpty() && size(boxes[i]) <= kStageTimes * size(solid))
            things.include(boxes[i]);
    return things;
}

ArrowPlace arrowPlace(const Bounds& things, const Light& directional) {
    if (things.isEmpty()) return {};
    const dvec3 half = 0.5 * (things.upperWorld - things.lowerWorld);
    const double reach = glm::dot(half, glm::abs(directional.directionWorld)); // of the box, toward the light
    const double length = 0.3 * glm::length(half);
    return {middle(things) - directional.directionWorld * (reach + 0.1 * length), length, 0.4 * length};
}

Camera outsideCameraFor(const Scene& scene, const Camera& eye, double aspect) {
    const Subject subject = subjectOf(scene, thingsBounds(scene), eye, aspect);
    const std::vector<Bounds> boxes = objectBounds(scene);
    Camera best;
    double fewest = std::numeric_limits<double>::infinity();
    for (const double above : {27.0, 14.0, 42.0})
        for (const double aside : {48.0, -48.0, 68.0, -68.0, 25.0, -25.0}) { // the first of equally good ones is taken
            const Camera camera = framing(subject.framed, axesBeside(eye, aside, above), eye.upWorld, aspect);
            const double faults = faultsOf(camera, subject, boxes);
            if (faults >= fewest) continue;
            fewest = faults;
            best = camera;
        }
    return best;
}

Camera widenedFor(Camera outside, double aspect) {
    constexpr double kUsual = 16.0 / 9.0;
    const double half = std::tan(glm::radians(outside.fovYDegrees) / 2) * std::max(1.0, kUsual / aspect);
    outside.fovYDegrees = 2 * glm::degrees(std::atan(half));
    return outside;
}

} // namespace shadowlab::scene
