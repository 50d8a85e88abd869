// SPDX-License-Identifier: MIT
#include "app/student/search/building_blocks.h"
#include "app/student/search/random_scenes.h"

namespace shadowlab::student {

namespace ray_tracing_scenes {
namespace {

SearchScene underALamp(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(20));
    scene.objects.push_back(anyBody(dice, "body1", dice.place({-1, 0.7, -1}, {1, 1.4, 1}), 1));
    scene.objects.push_back(anyBody(dice, "body2", dice.place({-1.4, 0.5, -1}, {1.4, 0.7, 1}), 0.8));
    scene.lights = {lamp(dice.place({-2.5, 3.2, -2}, {2.5, 4.5, 2.5}), 40)};
    lookFromAround(scene, dice, {0, 0.5, 0}, dice.real(3.0, 4.2));
    return scene;
}

SearchScene underTheSun(Dice& dice) {
    SearchScene scene = underALamp(dice);
    const dvec3 travels(dice.real(-0.6, 0.6), -1, dice.real(-0.6, 0.6));
    scene.lights = {sun(travels)};
    // High above: nothing is too far away to stand before the sun.
    const double rise = dice.real(30, 60);
    scene.objects.push_back(box("cloud", dvec3(0, 0, 0) - rise * travels, {1.6, 0.3, 1.6}, dice.real(0, 90)));
    return scene;
}

SearchScene behindTheLamp(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(20));
    scene.objects.push_back(anyBody(dice, "below", dice.place({-1, 0.5, -0.8}, {1, 0.7, 0.8}), 0.7));
    scene.objects.push_back(box("above", dice.place({-0.3, 3, -0.3}, {0.3, 3.6, 0.3}), {2.4, 0.2, 2.4}, dice.real(0, 90)));
    scene.lights = {lamp(dice.place({-0.4, 1.8, -0.4}, {0.4, 2.2, 0.4}), 20)};
    lookFromAround(scene, dice, {0, 0.5, 0}, 3.8);
    return scene;
}

/// Upright stripes in two colours, for mirrors and glass to show.
void addStripes(SearchScene& scene, double z) {
    for (int i = 0; i < 7; ++i)
        scene.objects.push_back(ofMaterial(sheet("stripe" + std::to_string(i + 1), {-1.5 + 0.5 * i, 0.8, z}, {0.25, 0, 0}, {0, 1.6, 0}),
                                           i % 2 ? "accent" : "blue"));
}

SearchScene aMirror(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(20));
    const double turn = dice.real(-0.4, 0.4);
    scene.objects.push_back(
        ofMaterial(sheet("mirror", {0, 1, -1.4}, {2.4 * std::cos(turn), 0, 2.4 * std::sin(turn)}, {0, 1.9, dice.real(-0.3, 0.3)}), "mirror"));
    scene.objects.push_back(anyBody(dice, "body1", dice.place({-0.9, 0.5, -0.4}, {-0.2, 0.7, 0.3}), 0.8));
    scene.objects.push_back(ofMaterial(box("body2", dice.place({0.3, 0.4, -0.4}, {0.9, 0.6, 0.3}), {0.5, 0.7, 0.5}, dice.real(0, 90)), "blue"));
    scene.lights = {lamp(dice.place({-1.5, 3, 1}, {1.5, 4, 2.5}), 40)};
    scene.eyeWorld = dice.place({-1.4, 1.4, 3.4}, {1.4, 2.2, 4.2});
    scene.targetWorld = {0, 0.8, -0.6};
    return scene;
}

SearchScene throughGlass(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(20));
    addStripes(scene, -1.5);
    const double size = dice.real(1, 1.3), turn = dice.real(15, 75);
    SearchObject body = dice.chance(0.5) ? box("glass", {0, 0.75, 0}, dvec3(size), turn) : ball("glass", {0, 0.8, 0.2}, size / 2);
    scene.objects.push_back(ofMaterial(std::move(body), "glass"));
    scene.lights = {lamp(dice.place({-1.5, 3.5, 1.5}, {1.5, 4.5, 2.5}), 44)};
    scene.eyeWorld = dice.place({-1.6, 1.2, 3.2}, {1.6, 2.2, 4});
    scene.targetWorld = {0, 0.7, -0.3};
    return scene;
}

SearchScene totalReflection(Dice& dice) {
    SearchScene scene = throughGlass(dice);
    scene.objects.back() = ofMaterial(box("cube", {0, 0.75, 0}, dvec3(dice.real(1.1, 1.4)), dice.real(25, 55)), "clear");
    scene.eyeWorld = dice.place({-1.8, 1.9, 3}, {1.8, 2.8, 3.6});
    return scene;
}

SearchScene betweenMirrors(Dice& dice) {
    SearchScene scene;
    scene.objects.push_back(floorOf(20));
    const double apart = dice.real(1.1, 1.5);
    for (const double side : {-1.0, 1.0})
        scene.objects.push_back(ofMaterial(
            sheet(side < 0 ? "left" : "right", {side * apart, 1.2, 0}, {0, 0, -3 * side * -1}, {0, 2.4, dice.real(-0.1, 0.1)}), "mirror"));
    scene.objects.push_back(anyBody(dice, "body", dice.place({-0.4, 0.5, -0.6}, {0.4, 0.7, 0.2}), 0.7));
    scene.lights = {lamp(dice.place({-0.3, 2.4, -0.4}, {0.3, 2.9, 0.6}), 16)};
    scene.eyeWorld = {0.7 * apart, dice.real(1.1, 1.5), dice.real(1.1, 1.4)};
    scene.targetWorld = {-apart, 0.8, dice.real(-0.6, -0.3)};
    scene.fovYDegrees = 56;
    return scene;
}

SearchScene treesOfTwoBranches(Dice& dice) {
    SearchScene scene = betweenMirrors(dice);
    scene.objects.push_back(ofMaterial(box("glass", dice.place({-0.3, 0.9, 0.1}, {0.1, 1.2, 0.4}), dvec3(0.5), dice.real(0, 90)), "glass"));
    return scene;
}

} // namespace
} // namespace ray_tracing_scenes

std::span<const SceneKind> rayTracingKinds() {
    using namespace ray_tracing_scenes;
    constexpr Judged v = Judged::visibility, p = Judged::picture;
    static const std::vector<SceneKind> kinds = {
        {"bodies under a lamp", {1, 2}, v, underALamp},
        {"the sun, and what is far away before it", {2}, v, underTheSun},
        {"what stands behind the lamp", {2}, v, behindTheLamp},
        {"a mirror", {3, 7, 8}, p, aMirror},
        {"glass", {4, 5, 7, 8}, p, throughGlass},
        {"total reflection", {5}, p, totalReflection},
        {"mirrors that face each other", {6}, p, betweenMirrors},
        {"trees with two branches", {7, 8}, p, treesOfTwoBranches},
    };
    return kinds;
}

} // namespace shadowlab::student
