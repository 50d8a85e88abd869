// SPDX-License-Identifier: MIT
#include "app/student/search/building_blocks.h"
#include "app/student/search/random_scenes.h"

namespace shadowlab::student {

namespace radiosity_scenes {
namespace {

SearchScene aRoom() {
    SearchScene scene;
    scene.isRoom = true;
    scene.background = 0;
    return scene;
}

/// A square panel that faces down.
SearchObject panel(const dvec3& center, double side) {
    return ofMaterial(sheet("panel", center, {side, 0, 0}, {0, 0, side}), "shining");
}

void lookIn(SearchScene& scene, Dice& dice) {
    scene.eyeWorld = dice.place({-2.4, 2, 3.6}, {2.4, 2.8, 4.4});
    scene.targetWorld = {0, 0.4, 0};
}

SearchScene parallel(Dice& dice) {
    SearchScene scene = aRoom();
    scene.objects.push_back(floorOf(4));
    scene.objects.push_back(panel({dice.real(-0.4, 0.4), dice.real(1, 1.5), dice.real(-0.4, 0.4)}, dice.real(1, 1.6)));
    lookIn(scene, dice);
    return scene;
}

SearchScene atRightAngles(Dice& dice) {
    SearchScene scene = aRoom();
    scene.objects.push_back(floorOf(4));
    const double height = dice.real(1.2, 2);
    scene.objects.push_back(ofMaterial(sheet("wall", {0, height / 2, -2}, {4, 0, 0}, {0, height, 0}), "shining"));
    lookIn(scene, dice);
    return scene;
}

SearchScene aScreen(Dice& dice) {
    SearchScene scene = atRightAngles(dice);
    scene.objects.push_back(
        ofMaterial(sheet("screen", {dice.real(-0.6, 0.6), 0.7, dice.real(-1, -0.5)}, {dice.real(2, 2.6), 0, 0}, {0, 1.3, 0}), "black"));
    return scene;
}

SearchScene areas(Dice& dice) {
    SearchScene scene = parallel(dice);
    scene.objects.back() = panel({dice.real(-0.4, 0.4), dice.real(0.6, 0.9), dice.real(-0.3, 0.3)}, dice.real(0.5, 0.7));
    scene.objects.push_back(box("block", {dice.real(-1.2, -0.7), 0.3, 0.2}, {0.5, 0.6, 0.5}, dice.real(0, 60)));
    return scene;
}

SearchScene furnace(Dice& dice) {
    SearchScene scene = aRoom();
    SearchObject room = box("room", {0, 1.5, 0}, {dice.real(3.4, 4.4), 3, dice.real(3.4, 4.4)});
    scene.objects.push_back(ofMaterial(std::move(room), "glowing"));
    scene.eyeWorld = dice.place({-1.4, 1, 1}, {-0.8, 1.8, 1.4});
    scene.targetWorld = {0.6, 1.3, -1};
    scene.fovYDegrees = 60;
    return scene;
}

SearchScene aLamp(Dice& dice) {
    SearchScene scene = aRoom();
    scene.objects.push_back(floorOf(4));
    scene.objects.push_back(sheet("back", {0, 1.2, -2}, {4, 0, 0}, {0, 2.4, 0}));
    scene.objects.push_back(ofMaterial(box("block", {dice.real(-0.8, 0.8), 0.4, dice.real(-0.8, 0.2)}, {0.7, 0.8, 0.7}, dice.real(0, 90)), "accent"));
    scene.lights = {lamp(dice.place({-1, 1.8, -0.5}, {1, 2.4, 1}), 3)};
    lookIn(scene, dice);
    return scene;
}

SearchScene underTheSky(Dice& dice) {
    SearchScene scene = aRoom();
    scene.background = 0.8;
    scene.objects.push_back(floorOf(4));
    scene.objects.push_back(ofMaterial(box("block", {dice.real(-0.5, 0.5), 0.6, dice.real(-0.5, 0.3)}, {1, 1.2, 1}, dice.real(0, 90)), "accent"));
    lookIn(scene, dice);
    return scene;
}

SearchScene colours(Dice& dice) {
    SearchScene scene = aRoom();
    scene.objects.push_back(floorOf(3));
    scene.objects.push_back(ofMaterial(sheet("left", {-1.5, 1.2, 0}, {0, 0, -3}, {0, 2.4, 0}), "accent"));
    scene.objects.push_back(sheet("back", {0, 1.2, -1.5}, {3, 0, 0}, {0, 2.4, 0}));
    scene.objects.push_back(panel({dice.real(-0.4, 0.4), 2.2, dice.real(-0.4, 0.4)}, dice.real(1.2, 1.8)));
    scene.eyeWorld = dice.place({0, 1.4, 3.4}, {1, 2, 4});
    scene.targetWorld = {-0.3, 0.9, 0};
    return scene;
}

} // namespace
} // namespace radiosity_scenes

std::span<const SceneKind> radiosityKinds() {
    using namespace radiosity_scenes;
    constexpr Judged p = Judged::picture;
    static const std::vector<SceneKind> kinds = {
        {"parallel patches", {1}, p, parallel},
        {"what stands between two patches", {2}, p, aScreen},
        {"a small patch and a large one", {3}, p, areas},
        {"a lamp, which is no patch", {4}, p, aLamp},
        {"a closed room that shines", {5, 4}, p, furnace},
        {"patches at right angles", {1}, p, atRightAngles},
        {"an open place under the sky", {4, 5}, p, underTheSky},
        {"colours of what reflects", {5}, p, colours},
    };
    return kinds;
}

} // namespace shadowlab::student
