// SPDX-License-Identifier: MIT
#include "app/student/search/building_blocks.h"
#include "app/student/search/random_scenes.h"

namespace shadowlab::student {

namespace shadow_volume_scenes {
namespace {

SearchScene underALamp(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(20));
    addBodies(scene, dice, 1.2, 1.4);
    scene.lights = {lamp(dice.place({-2.5, 3.2, -2}, {2.5, 4.5, 2.5}), 40)};
    lookFromAround(scene, dice, {0, 0.4, 0}, dice.real(3.3, 4.9));
    return scene;
}

SearchScene underTheSun(Dice& dice) { return inTheSun(underALamp(dice), dice); }

SearchScene onItself(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(20));
    scene.objects.push_back(ofMaterial(star("star", {0, 0.8, 0}, dice.place({1.4, 0.8, 1.4}, {2, 1.4, 2}), 3 + dice.below(4), dice.real(0, 60)),
                                       "accent"));
    scene.lights = {lamp(dice.place({-2.5, 1, 1}, {2.5, 3, 3}), 30)};
    lookFromAround(scene, dice, {0, 0.6, 0}, 3.5);
    return scene;
}

SearchScene eyeInShadow(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(40));
    scene.objects.push_back(box("roof", {-1, 2.45, 2.6}, {dice.real(6, 7), 0.2, dice.real(4, 5)}));
    scene.objects.push_back(anyBody(dice, "body", dice.place({-0.8, 0.6, -2.8}, {0.8, 0.8, -2.2}), 1));
    scene.lights = {sun({dice.real(0.5, 0.8), -1, dice.real(-0.4, -0.2)})};
    scene.eyeWorld = dice.place({-0.8, 1.2, 3.2}, {0, 1.6, 3.8});
    scene.targetWorld = {0, 0.8, -2.2};
    return scene;
}

SearchScene alongTheLight(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(40));
    scene.objects.push_back(anyBody(dice, "body", dice.place({-0.8, 0.7, -0.3}, {0.5, 1, 0.6}), 0.8));
    if (dice.chance(0.5)) scene.objects.push_back(box("wall", {0, 4, -3.1}, {12, 8, 0.2}));
    scene.eyeWorld = dice.place({-0.3, 1.3, 4}, {0.3, 1.8, 4.4});
    scene.targetWorld = {0, 0.9, 0};
    scene.lights = {lamp(scene.eyeWorld + dice.place({0.3, 0.5, 0.1}, {0.7, 0.9, 0.4}), 50)};
    return scene;
}

SearchScene mirrored(Dice& dice) {
    SearchScene scene = underALamp(dice);
    for (std::size_t i = 1; i < scene.objects.size(); ++i)
        scene.objects[i].isMirrored = dice.chance(0.7);
    return scene;
}

SearchScene aRow(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(40));
    const int boards = 3 + dice.below(4);
    for (int i = 0; i < boards; ++i)
        scene.objects.push_back(box("board" + std::to_string(i + 1), {-1.2 + 0.45 * i, 0.46, dice.real(-0.2, 0.2)}, {0.06, 0.9, 0.7}));
    scene.lights = {sun({-1, dice.real(-0.6, -0.4), dice.real(-0.2, 0.2)})};
    scene.eyeWorld = dice.place({-4, 1.7, 2.6}, {-3, 2.4, 3.4});
    scene.targetWorld = {-0.6, 0.4, 0};
    return scene;
}

/// One face of a body is turned away from the lamp by one to three degrees only, and all is small: so is N.L, whether its vectors are of unit length or not.
SearchScene almostAlongAFace(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(20));
    const SearchObject body = pyramid("body", {0, 0.32, 0}, dice.place({0.5, 0.5, 0.5}, {0.6, 0.6, 0.6}), dice.real(0, 360));
    const uvec3 face = body.triangles[static_cast<std::size_t>(1 + dice.below(3))]; // not the lowest
    const std::vector<dvec3>& corners = body.cornersWorld;
    const dvec3 a = corners[face.x], normal = glm::normalize(glm::cross(corners[face.y] - a, corners[face.z] - a));
    const dvec3 middle = (a + corners[face.y] + corners[face.z]) / 3.0;
    const dvec3 up = glm::normalize(dvec3(0, 1, 0) - normal.y * normal), across = glm::cross(normal, up);
    const double turn = glm::radians(dice.real(-30, 30)), away = glm::radians(dice.real(1, 3)), distance = dice.real(1.1, 1.3);
    const dvec3 along = std::cos(turn) * up + std::sin(turn) * across;
    scene.lights = {lamp(middle + distance * (std::cos(away) * along - std::sin(away) * normal), 5)};
    scene.objects.push_back(ofMaterial(body, "accent"));
    lookFromAround(scene, dice, {0, 0.12, 0}, dice.real(1.4, 1.6));
    return scene;
}

SearchScene longShadows(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(400));
    scene.objects.push_back(box("wall", {0, 20, -80.5}, {120, 40, 1}));
    scene.objects.push_back(box("post", {dice.real(-0.6, 0.9), 0.8, dice.real(8, 9)}, {0.4, 1.4, 0.4}, dice.real(0, 90)));
    scene.lights = {lamp({dice.real(0.8, 1.6), dice.real(0.9, 1.3), 12}, 1200)};
    scene.eyeWorld = {dice.real(3, 5), dice.real(2.6, 3.6), 16};
    scene.targetWorld = {-1.5, 1.6, -20};
    scene.fovYDegrees = 28;
    return scene;
}

SearchScene twoLights(Dice& dice) { return withTheSun(underALamp(dice), dice); }

} // namespace
} // namespace shadow_volume_scenes

std::span<const SceneKind> shadowVolumeKinds() {
    using namespace shadow_volume_scenes;
    constexpr Judged v = Judged::visibility;
    static const std::vector<SceneKind> kinds = {
        {"bodies under a lamp", {1, 2, 3, 5, 6}, v, underALamp},
        {"bodies in the sun", {1, 2, 3, 5, 6}, v, underTheSun},
        {"a body that shadows itself", {1, 2}, v, onItself},
        {"the eye in a shadow", {7, 5}, v, eyeInShadow},
        {"the eye looks along the volumes", {4}, v, alongTheLight},
        {"a shadow that falls far", {3}, v, longShadows},
        {"several volumes one behind the other", {5, 6}, v, aRow},
        {"a mesh that a mirror has turned inside out", {1, 2}, v, mirrored},
        {"two lights", {1, 2}, v, twoLights},
        {"a face almost along the light", {1, 2}, v, almostAlongAFace},
    };
    return kinds;
}

} // namespace shadowlab::student
