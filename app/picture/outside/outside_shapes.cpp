// SPDX-License-Identifier: MIT
#include "app/picture/outside/outside_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/scene/query/outside_camera.h"

namespace shadowlab::picture {

namespace {

constexpr double kBeyond = 1.1;     ///< of the depth of the farthest thing: where the eye's view is cut off
constexpr double kStarShare = 0.03; ///< of half the picture's height: readable, and no larger than a thing
constexpr int kRound = 32;          ///< segments of a circle

using Points = std::vector<dvec3>;

void addSegment(Points& points, const dvec3& a, const dvec3& b) { points.insert(points.end(), {a, b}); }

template <std::size_t Count>
void addLoop(Points& points, const std::array<dvec3, Count>& corners) {
    for (std::size_t i = 0; i < Count; ++i)
        addSegment(points, corners[i], corners[(i + 1) % Count]);
}

/// Two unit vectors that make a right-handed frame with a third.
std::array<dvec3, 2> acrossOf(const dvec3& direction) {
    const dvec3 helper = std::abs(direction.y) > 0.9 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    const dvec3 u = glm::normalize(glm::cross(helper, direction));
    return {u, glm::cross(direction, u)};
}

void addCircle(Points& points, const dvec3& centre, const dvec3& u, const dvec3& v) {
    std::array<dvec3, kRound> corners;
    for (int i = 0; i < kRound; ++i) {
        const double angle = i * glm::two_pi<double>() / kRound;
        corners[static_cast<std::size_t>(i)] = centre + std::cos(angle) * u + std::sin(angle) * v;
    }
    addLoop(points, corners);
}

void addArrow(Points& points, const dvec3& tip, const dvec3& direction, double length) {
    const auto [u, v] = acrossOf(direction);
    addSegment(points, tip - length * direction, tip);
    for (const dvec3& side : {u, -u, v, -v})
        addSegment(points, tip, tip - 0.22 * length * direction + 0.09 * length * side);
}

/// The 13 axes of a cube: along its edges, across its faces, through its corners. A star from everywhere.
void addStar(Points& points, const dvec3& centre, double radius) {
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (const dvec3 axis(x, y, z); axis != dvec3(0.0))
                    addSegment(points, centre, centre + radius * glm::normalize(axis));
}

/// Metres that a kStarShare of half the picture's height is at that place.
double signRadius(const dvec3& placeWorld, const scene::Camera& outside) {
    const double halfHeight = std::tan(glm::radians(outside.fovYDegrees / 2));
    return kStarShare * halfHeight * glm::length(placeWorld - outside.positionWorld);
}

Points lightSign(const scene::Light& light, const scene::Bounds& things, const scene::Camera& outside) {
    Points points;
    const dvec3& place = light.positionWorld;
    const double radius = signRadius(place, outside);
    switch (light.type) {
    case scene::LightType::point: addStar(points, place, radius); break;
    case scene::LightType::directional: {
        const scene::ArrowPlace arrow = scene::arrowPlace(things, light);
        const auto [u, v] = acrossOf(light.directionWorld);
        // Five, as on a die: nine would hide one another.
        for (const dvec2& pip : {dvec2(0, 0), dvec2(1, 1), dvec2(1, -1), dvec2(-1, 1), dvec2(-1, -1)})
            addArrow(points, arrow.tipWorld + arrow.spread / std::sqrt(2.0) * (pip.x * u + pip.y * v),
                     light.directionWorld, arrow.length);
        break;
    }
    case scene::LightType::spot: {
        const double half = glm::radians(light.coneDegrees / 2), length = 6 * radius;
        const auto [u, v] = acrossOf(light.directionWorld);
        const dvec3 centre = place + length * std::cos(half) * light.directionWorld;
        const double wide = length * std::sin(half);
        addCircle(points, centre, wide * u, wide * v);
        for (const dvec3& side : {u, -u, v, -v})
            addSegment(points, place, centre + wide * side);
        break;
    }
    case scene::LightType::rect: {
        const dvec3 u = 0.5 * light.edgeUWorld, v = 0.5 * light.edgeVWorld;
        addLoop(points, std::array{place - u - v, place + u - v, place + u + v, place - u + v});
        const double length = 0.5 * std::sqrt(glm::length(light.edgeUWorld) * glm::length(light.edgeVWorld));
        const dvec3 normalWorld = scene::rectNormalWorld(light);
        addArrow(points, place + length * normalWorld, normalWorld, length);
        break;
    }
    case scene::LightType::sphere:
        addCircle(points, place, {light.radius, 0, 0}, {0, light.radius, 0});
        addCircle(points, place, {0, light.radius, 0}, {0, 0, light.radius});
        addCircle(points, place, {0, 0, light.radius}, {light.radius, 0, 0});
        break;
    }
    return points;
}

} // namespace

double shownDepth(const scene::Scene& scene, const View& eye) {
    const dmat4 viewFromWorld = scene::viewFromWorld(eye.camera);
    const scene::Bounds things = scene::thingsBounds(scene);
    double farthest = 0;
    for (int i = 0; i < 8 && !things.isEmpty(); ++i)
        farthest = std::max(farthest, -transformPoint(viewFromWorld, things.corner(i)).z);
    if (farthest <= eye.camera.near) // nothing stands before the eye
        farthest = std::max(2 * eye.camera.near, glm::length(eye.camera.targetWorld - eye.camera.positionWorld));
    return kBeyond * farthest;
}

std::vector<SceneShape> eyeShapes(const scene::Scene& scene, const View& eye) {
    const double aspect = static_cast<double>(eye.size.x) / eye.size.y;
    const std::array<dvec3, 4> far = scene::viewCorners(eye.camera, aspect, shownDepth(scene, eye));
    SceneShape view{"view of the eye", look::kEye, SceneShape::Kind::lines, {}};
    SceneShape nearPlane{"near plane of the eye", look::kEye, SceneShape::Kind::lines, {}};
    addLoop(nearPlane.pointsWorld, scene::viewCorners(eye.camera, aspect, eye.camera.near));
    addLoop(view.pointsWorld, far);
    for (const dvec3& corner : far)
        addSegment(view.pointsWorld, eye.camera.positionWorld, corner);
    return {std::move(view), std::move(nearPlane)};
}

std::vector<SceneShape> lightShapes(const scene::Scene& scene, const scene::Bounds& things, int light,
                                    const scene::Camera& outside) {
    SceneShape chosen{"", look::kChosenLight, SceneShape::Kind::lines, {}};
    SceneShape others{"other lights", look::kOtherLight, SceneShape::Kind::lines, {}};
    for (int i = 0; i < static_cast<int>(scene.lights.size()); ++i) {
        const scene::Light& source = scene.light(i);
        SceneShape& shape = i == light ? chosen : others;
        if (i == light) shape.label = "light " + source.name;
        const Points sign = lightSign(source, things, outside);
        shape.pointsWorld.insert(shape.pointsWorld.end(), sign.begin(), sign.end());
    }
    std::vector<SceneShape> shapes;
    for (SceneShape* shape : {&others, &chosen})
        if (!shape->pointsWorld.empty()) shapes.push_back(std::move(*shape));
    return shapes;
}

} // namespace shadowlab::picture
