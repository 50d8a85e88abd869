// SPDX-License-Identifier: MIT
#include "tests/support/plane_view.h"

#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/scenes.h"

namespace shadowlab::testing {

namespace {

constexpr double kEyeHeight = 10;

} // namespace

scene::Camera PlaneView::camera() const {
    scene::Camera camera;
    camera.positionWorld = {centre.x, kEyeHeight, centre.y};
    camera.targetWorld = {centre.x, 0, centre.y};
    camera.upWorld = {0, 0, -1}; // rows go toward +z
    camera.fovYDegrees = glm::degrees(2 * std::atan(0.5 * size.y / pixelsPerMetre / kEyeHeight));
    camera.near = kEyeHeight - 1e-6; // sees only what is lower than a micrometre: the plane
    return camera;
}

scene::Scene planeUnderLight(const dvec3& lightWorld) {
    scene::Scene scene = floorScene();
    scene.objects[0].worldFromObject[0][0] = 100; // a floor of 1000 x 1000
    scene.objects[0].worldFromObject[2][2] = 100;
    scene.lights.push_back(pointLight(lightWorld));
    return scene;
}

double EllipseInPicture::distancePx(dvec2 pixel) const {
    const dvec2 offset = pixel - middle;
    const double u = glm::dot(offset, along), v = offset.x * along.y - offset.y * along.x;
    const double value = std::sqrt(u * u / (a * a) + v * v / (b * b)) - 1;
    return value * (value + 1) / glm::length(dvec2(u / (a * a), v / (b * b))); // over the length of its gradient
}

double EllipseInPicture::lengthPx() const {
    const double h = (a - b) * (a - b) / ((a + b) * (a + b));
    return glm::pi<double>() * (a + b) * (1 + h / 4); // Ramanujan's series, two terms
}

SphereShadow sphereShadow(ivec2 size, int segments) {
    // The second of the cases in measure/closed_forms_test.cpp, where the formulas are.
    const dvec3 light{2, 4, 1}, centre{0, 1, 0};
    constexpr double kRadius = 0.5, kA = 0.8475655414, kB = 0.6761234038;
    const dvec2 middle{-0.7428571429, -0.3714285714};
    SphereShadow shadow{planeUnderLight(light), {}};
    addObject(shadow.scene, scene::makeSphere(kRadius, segments), translation(centre));
    const PlaneView view{middle, 0.3 * size.y / kB, size};
    shadow.scene.camera = view.camera();
    shadow.ellipse = {dvec2(size) / 2.0, glm::normalize(dvec2(light.x, light.z) - middle), kA * view.pixelsPerMetre,
                      kB * view.pixelsPerMetre};
    return shadow;
}

} // namespace shadowlab::testing
