// SPDX-License-Identifier: MIT
#include "app/student/search/building_blocks.h"
#include "app/student/search/random_scenes.h"

namespace shadowlab::student {

namespace planar_scenes {
namespace {

/// One to three bodies that stand on the floor, or hang above it.
void addStandingOrHanging(SearchScene& scene, Dice& dice) {
    const int count = 1 + dice.below(3);
    for (int i = 0; i < count; ++i) {
        const double size = dice.real(0.5, 1.1), rise = dice.chance(0.5) ? 0.61 * size : dice.real(0.9, 1.4);
        scene.objects.push_back(anyBody(dice, "body" + std::to_string(i + 1), {dice.real(-1.3, 1.3), rise, dice.real(-1.3, 1.3)}, size));
    }
}

SearchScene underALamp(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(20));
    addStandingOrHanging(scene, dice);
    scene.lights = {lamp(dice.place({-2.5, 3.2, -2}, {2.5, 4.5, 2.5}), 40)};
    lookFromAround(scene, dice, {0, 0.4, 0}, dice.real(3.3, 4.9));
    return scene;
}

SearchScene underTheSun(Dice& dice) { return inTheSun(underALamp(dice), dice); }

SearchScene aboveTheLamp(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(20));
    scene.objects.push_back(anyBody(dice, "below", dice.place({-1.2, 0.5, -0.6}, {1.2, 0.8, 0.6}), 0.6));
    scene.objects.push_back(anyBody(dice, "above", dice.place({-1, 2.6, -0.6}, {1, 3, 0.6}), 0.6));
    scene.lights = {lamp(dice.place({-0.3, 1.7, -0.3}, {0.3, 1.9, 0.3}), 26)};
    scene.eyeWorld = {dice.real(-1.2, 1.2), dice.real(2, 2.6), 5.4};
    scene.targetWorld = {0, 1.1, 0};
    return scene;
}

SearchScene pastTheLampsHeight(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(40));
    const double top = dice.real(2, 3);
    scene.objects.push_back(box("post", {dice.real(-1, 0), top / 2, dice.real(-0.5, 0.5)}, {0.4, top, 0.4}, dice.real(0, 90)));
    scene.lights = {lamp({dice.real(0.9, 1.8), dice.real(1, 1.6), dice.real(-0.5, 0.8)}, 20)};
    lookFromAround(scene, dice, {-0.5, 0.6, 0}, 4.2);
    return scene;
}

SearchScene sunk(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(20));
    const double size = dice.real(0.9, 1.4);
    scene.objects.push_back(anyBody(dice, "body", {dice.real(-0.5, 0.5), dice.real(-0.1, 0.2), dice.real(-0.5, 0.5)}, size));
    scene.lights = {lamp({dice.real(1.6, 2.6), dice.real(1.3, 2), dice.real(-1, 1)}, 16)};
    lookFromAround(scene, dice, {0, 0.1, 0}, 3.5);
    return scene;
}

SearchScene aTable(Dice& dice) {
    SearchScene scene;
    const double height = dice.real(0.7, 1);
    scene.objects.push_back(floorOf(20));
    scene.objects.push_back(box("table", {0, height - 0.05, 0}, {dice.real(1.2, 1.8), 0.1, dice.real(1, 1.4)}, dice.real(0, 90)));
    scene.objects.push_back(anyBody(dice, "body", {dice.real(-0.3, 0.3), height + 0.5, dice.real(-0.3, 0.3)}, 0.7));
    scene.lights = {lamp({dice.real(0.6, 1.4), height + dice.real(1.5, 2.2), dice.real(-0.8, 0.8)}, 24)};
    lookFromAround(scene, dice, {-0.4, 0.6, 0}, 3.5);
    return scene;
}

SearchScene aCorner(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(5));
    scene.objects.push_back(sheet("back", {0, 1.5, -2.5}, {5, 0, 0}, {0, 3, 0}));
    scene.objects.push_back(sheet("left", {-2.5, 1.5, 0}, {0, 0, -5}, {0, 3, 0}));
    scene.objects.push_back(anyBody(dice, "body", dice.place({-1.2, 0.6, -1.2}, {0.2, 1.2, 0.2}), 0.9));
    scene.lights = {lamp(dice.place({0.8, 1.8, 0.8}, {2, 2.8, 2}), 24)};
    scene.eyeWorld = dice.place({1, 1.6, 3.2}, {2.4, 2.4, 4});
    scene.targetWorld = {-0.7, 0.8, -0.7};
    return scene;
}

SearchScene sheets(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(20));
    const double angle = dice.real(0, 3);
    scene.objects.push_back(ofMaterial(
        sheet("screen", {0, 0.7, 0}, {1.6 * std::cos(angle), 0, 1.6 * std::sin(angle)}, {0, 1.2, dice.real(-0.5, 0.5)}), "accent"));
    if (dice.chance(0.5)) scene.lights = {anySun(dice)};
    else scene.lights = {lamp(dice.place({-2, 2.4, -2}, {2, 3.4, 2}), 30)};
    lookFromAround(scene, dice, {0, 0.4, 0}, 3.5);
    return scene;
}

SearchScene farAway(Dice& dice) {
    SearchScene scene = underTheSun(dice);
    scene.objects.front() = floorOf(400);
    scene.eyeWorld = {dice.real(-20, 20), dice.real(25, 45), 110}; // lower, and shadows on the floor are a few pixels high
    scene.targetWorld = {0, 0.5, 0};
    scene.fovYDegrees = 1.5;
    return scene;
}

SearchScene twoLights(Dice& dice) { return withTheSun(underALamp(dice), dice); }

} // namespace
} // namespace planar_scenes

std::span<const SceneKind> planarKinds() {
    using namespace planar_scenes;
    constexpr Judged v = Judged::visibility;
    static const std::vector<SceneKind> kinds = {
        {"bodies under a lamp", {1, 2}, v, underALamp},
        {"bodies in the sun", {1, 2}, v, underTheSun},
        {"a body that is sunk into the floor", {4}, v, sunk},
        {"a table over the floor", {3}, v, aTable},
        {"a body above the lamp", {1}, v, aboveTheLamp},
        {"a caster that reaches past the lamp's height", {1}, v, pastTheLampsHeight},
        {"a corner of three planes", {2, 3}, v, aCorner},
        {"a sheet, lit from either side", {1, 2}, v, sheets},
        {"seen from far away", {1, 2}, v, farAway},
        {"two lights", {1, 2}, v, twoLights},
    };
    return kinds;
}

} // namespace shadowlab::student
