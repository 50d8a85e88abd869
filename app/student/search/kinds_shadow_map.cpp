// SPDX-License-Identifier: MIT
#include "app/student/search/building_blocks.h"
#include "app/student/search/random_scenes.h"

namespace shadowlab::student {

namespace shadow_map_scenes {
namespace {

/// A floor that casts nothing, so that the map is fitted to what stands on it.
SearchObject bareFloor(double side) {
    SearchObject floor = floorOf(side);
    floor.castsShadow = false;
    return floor;
}

SearchScene underALamp(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(bareFloor(20));
    addBodies(scene, dice, 1, 1.3);
    scene.lights = {lamp(dice.place({-2.5, 3.4, -2}, {2.5, 4.5, 2.5}), 40)};
    lookFromAround(scene, dice, {0, 0.4, 0}, dice.real(3.0, 4.2));
    return scene;
}

SearchScene underTheSun(Dice& dice) { return inTheSun(underALamp(dice), dice); }

SearchScene grazed(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(bareFloor(20));
    scene.objects.push_back(box("slab", {0, 0.15, 0}, {dice.real(2.4, 3.4), 0.3, dice.real(1.8, 2.6)}, dice.real(0, 40)));
    scene.objects.push_back(ofMaterial(box("post", {dice.real(0.3, 0.8), 0.6, dice.real(-0.4, 0.4)}, {0.2, 0.6, 0.2}, 20), "accent"));
    scene.lights = {sun({-1, dice.real(-0.2, -0.1), dice.real(-0.3, 0.3)})};
    lookFromAround(scene, dice, {0, 0.2, 0}, 3.5);
    return scene;
}

SearchScene contact(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(bareFloor(20));
    scene.objects.push_back(box("wall", {0, 0.25, 0}, {0.04, 0.5, dice.real(1, 1.6)}, dice.real(-20, 20)));
    scene.objects.push_back(anyBody(dice, "body", dice.place({2, 1.2, -2}, {3, 1.8, -1}), 1.4));
    scene.lights = {sun({-1, -1, dice.real(-0.3, 0.3)})};
    scene.eyeWorld = dice.place({-1.8, 1.1, 2}, {-1.2, 1.6, 2.6});
    scene.targetWorld = {-0.3, 0.2, 0};
    return scene;
}

/// The sun runs along a wall that stands close to its shadow: a bias that grows with the slope is largest there, and so is the gap that too
/// large a one leaves.
SearchScene grazedContact(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(bareFloor(20));
    scene.objects.push_back(box("wall", {0, 0.4, 0}, {0.04, 0.8, dice.real(1.6, 2.2)}, dice.real(-8, 8)));
    scene.objects.push_back(anyBody(dice, "body", dice.place({2, 1.2, -2}, {3, 1.8, -1}), 1.4));
    scene.lights = {sun({-0.5, dice.real(-0.8, -0.6), dice.real(0.8, 1.1)})};
    scene.eyeWorld = dice.place({-1.8, 1.4, 1.4}, {-1.2, 1.8, 2});
    scene.targetWorld = {-0.2, 0.1, 0.2};
    return scene;
}

SearchScene behindTheLamp(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(bareFloor(8));
    scene.objects.push_back(ofMaterial(sheet("wall", {-2.4, 2, 0}, {0, 0, -6}, {0, 4, 0}), "ground"));
    scene.objects.back().castsShadow = false;
    scene.objects.push_back(anyBody(dice, "body", dice.place({1.4, 1, -0.4}, {2, 1.5, 0.4}), 1));
    scene.lights = {lamp(dice.place({-0.3, 1.2, -0.3}, {0.1, 1.6, 0.3}), 18)};
    scene.eyeWorld = dice.place({-0.5, 2, 5}, {1, 2.8, 6});
    scene.targetWorld = {-0.2, 1, 0};
    return scene;
}

SearchScene round(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(bareFloor(20));
    scene.objects.push_back(ofMaterial(ball("ball", dice.place({-0.5, 0.8, -0.5}, {0.5, 1.2, 0.5}), dice.real(0.6, 0.8)), "accent"));
    scene.lights = {lamp(dice.place({-2, 3, -1}, {2, 4, 2}), 36)};
    lookFromAround(scene, dice, {0, 0.6, 0}, 2.8);
    return scene;
}

SearchScene aThinSheet(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(bareFloor(20));
    scene.objects.push_back(ofMaterial(box("sheet", {0, dice.real(0.5, 0.9), 0}, {1.2, 0.001, 0.9}, dice.real(0, 90)), "accent"));
    scene.objects.push_back(box("block", {-0.9, 0.2, 0.7}, {0.4, 0.4, 0.4}));
    scene.lights = {lamp(dice.place({-1.5, 3, -1}, {1.5, 4, 1.5}), 36)};
    lookFromAround(scene, dice, {-0.2, 0.3, 0}, 3.1);
    return scene;
}

SearchScene aDistantLamp(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(bareFloor(20));
    scene.objects.push_back(anyBody(dice, "body", {dice.real(-0.6, 0.6), 0.45, dice.real(-0.4, 0.4)}, dice.real(0.5, 0.7)));
    scene.objects.push_back(box("block", {dice.real(0.6, 1), 0.15, 0.4}, {0.3, 0.3, 0.3}, dice.real(0, 90)));
    scene.lights = {lamp(dice.place({-120, 180, -120}, {120, 220, 120}), 180000)};
    lookFromAround(scene, dice, {0, 0.2, 0}, 2.8);
    return scene;
}

SearchScene twoLights(Dice& dice) { return withTheSun(underALamp(dice), dice); }

} // namespace
} // namespace shadow_map_scenes

std::span<const SceneKind> shadowMapKinds() {
    using namespace shadow_map_scenes;
    constexpr Judged v = Judged::visibility;
    static const std::vector<SceneKind> kinds = {
        {"bodies under a lamp", {2, 4, 5}, v, underALamp},
        {"bodies in the sun", {1, 4, 5}, v, underTheSun},
        {"a surface that the light grazes", {3}, v, grazed},
        {"what lies behind the lamp", {4}, v, behindTheLamp},
        {"a lamp far away", {2}, v, aDistantLamp},
        {"a shadow where its caster stands", {3}, v, contact},
        {"a wall that the light runs along", {3}, v, grazedContact},
        {"a round body", {3}, v, round},
        {"a sheet one millimetre thick", {3}, v, aThinSheet},
        {"two lights", {1, 2}, v, twoLights},
    };
    return kinds;
}

} // namespace shadowlab::student
