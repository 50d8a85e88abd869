// SPDX-License-Identifier: MIT
#include "app/student/search/building_blocks.h"

#include <array>
#include <map>
#include <utility>

#include <glm/gtc/constants.hpp>

namespace shadowlab::student {

namespace {

dvec3 turned(const dvec3& v, double degrees) {
    const double a = glm::radians(degrees), c = std::cos(a), s = std::sin(a);
    return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

/// Puts a body of the unit cube in its place.
SearchObject placed(SearchObject object, const dvec3& center, const dvec3& size, double turnDegrees) {
    for (dvec3& corner : object.cornersWorld)
        corner = center + turned(corner * size, turnDegrees);
    return object;
}

void addPolygon(SearchObject& object, const std::vector<unsigned>& corners) {
    for (std::size_t i = 2; i < corners.size(); ++i)
        object.triangles.emplace_back(corners[0], corners[i - 1], corners[i]);
}

} // namespace

SearchObject box(const std::string& name, const dvec3& center, const dvec3& size, double turnDegrees) {
    SearchObject object{name};
    for (int i = 0; i < 8; ++i)
        object.cornersWorld.emplace_back(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    for (const auto& face : std::to_array<std::array<unsigned, 4>>(
             {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}}))
        addPolygon(object, {face.begin(), face.end()});
    return placed(std::move(object), center, size, turnDegrees);
}

SearchObject pyramid(const std::string& name, const dvec3& center, const dvec3& size, double turnDegrees) {
    SearchObject object{name};
    object.cornersWorld = {{-0.5, -0.5, -0.5}, {0.5, -0.5, -0.5}, {0, -0.5, 0.5}, {0, 0.5, 0}};
    object.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    return placed(std::move(object), center, size, turnDegrees);
}

SearchObject star(const std::string& name, const dvec3& center, const dvec3& size, int tips, double turnDegrees) {
    SearchObject object{name};
    const unsigned n = 2 * static_cast<unsigned>(tips);
    for (unsigned layer = 0; layer < 2; ++layer)
        for (unsigned i = 0; i < n; ++i) {
            const double angle = glm::two_pi<double>() * i / n, radius = i % 2 ? 0.2 : 0.5;
            object.cornersWorld.emplace_back(radius * std::sin(angle), layer - 0.5, radius * std::cos(angle));
        }
    for (unsigned layer = 0; layer < 2; ++layer) // the middles of bottom and top
        object.cornersWorld.emplace_back(0, layer - 0.5, 0);
    for (unsigned i = 0; i < n; ++i) {
        const unsigned j = (i + 1) % n;
        addPolygon(object, {i, j, n + j, n + i});
        addPolygon(object, {2 * n, j, i});
        addPolygon(object, {2 * n + 1, n + i, n + j});
    }
    return placed(std::move(object), center, size, turnDegrees);
}

SearchObject ball(const std::string& name, const dvec3& center, double radius) {
    SearchObject object{name};
    const double g = glm::golden_ratio<double>();
    object.cornersWorld = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0}, {0, -1, g}, {0, 1, g},
                           {0, -1, -g}, {0, 1, -g}, {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
    const std::vector<uvec3> coarse = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},   {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                       {3, 8, 9},  {4, 9, 5},  {2, 4, 11},  {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    std::map<std::pair<unsigned, unsigned>, unsigned> middles;
    const auto middle = [&](unsigned a, unsigned b) {
        const auto [found, isNew] =
            middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<unsigned>(object.cornersWorld.size()));
        if (isNew) object.cornersWorld.push_back(object.cornersWorld[a] + object.cornersWorld[b]);
        return found->second;
    };
    for (const uvec3& t : coarse) {
        const unsigned ab = middle(t.x, t.y), bc = middle(t.y, t.z), ca = middle(t.z, t.x);
        for (const uvec3& fine : {uvec3(t.x, ab, ca), uvec3(t.y, bc, ab), uvec3(t.z, ca, bc), uvec3(ab, bc, ca)})
            object.triangles.push_back(fine);
    }
    for (dvec3& corner : object.cornersWorld)
        corner = center + radius * glm::normalize(corner);
    return object;
}

SearchObject sheet(const std::string& name, const dvec3& center, const dvec3& edgeU, const dvec3& edgeV) {
    SearchObject object{name};
    const dvec3 u = edgeU / 2.0, v = edgeV / 2.0;
    object.cornersWorld = {center - u - v, center + u - v, center + u + v, center - u + v};
    addPolygon(object, {0, 1, 2, 3});
    return object;
}

SearchObject floorOf(double side, double height) {
    SearchObject floor = sheet("floor", {0, height, 0}, {0, 0, side}, {side, 0, 0});
    floor.isWhole = true;
    return floor;
}

SearchObject ofMaterial(SearchObject object, const std::string& material) {
    object.material = material;
    return object;
}

SearchObject anyBody(Dice& dice, const std::string& name, const dvec3& center, double size) {
    const double turn = dice.real(0, 90);
    const dvec3 sides = size * dice.place({0.6, 0.6, 0.6}, {1.2, 1.2, 1.2});
    switch (dice.below(3)) {
    case 0: return ofMaterial(pyramid(name, center, sides, turn), "accent");
    case 1: return ofMaterial(star(name, center, sides, 3 + dice.below(3), turn), "accent");
    default: return ofMaterial(box(name, center, sides, turn), "accent");
    }
}

void addBodies(SearchScene& scene, Dice& dice, double reach, double highest) {
    const int count = 1 + dice.below(3);
    for (int i = 0; i < count; ++i) {
        // anyBody makes none higher than 1.2 times its size.
        const double size = dice.real(0.5, 1.1);
        scene.objects.push_back(
            anyBody(dice, "body" + std::to_string(i + 1), {dice.real(-reach, reach), dice.real(0.61 * size, highest), dice.real(-reach, reach)}, size));
    }
}

void lookFromAround(SearchScene& scene, Dice& dice, const dvec3& target, double distance) {
    const double angle = glm::radians(dice.real(-70, 70)), rise = glm::radians(dice.real(25, 50));
    const dvec3 away(std::cos(rise) * std::sin(angle), std::sin(rise), std::cos(rise) * std::cos(angle));
    scene.eyeWorld = glm::round((target + distance * away) * 100.0) / 100.0;
    scene.targetWorld = target;
}

SearchLight lamp(const dvec3& place, double intensity) { return {"lamp", false, place, intensity}; }
SearchLight sun(const dvec3& travels) { return {"sun", true, travels, 1}; }
SearchLight anySun(Dice& dice) { return sun({dice.real(-1, 1), -1, dice.real(-1, 1)}); }

SearchScene inTheSun(SearchScene scene, Dice& dice) {
    scene.lights = {anySun(dice)};
    return scene;
}

SearchScene withTheSun(SearchScene scene, Dice& dice) {
    scene.lights.push_back(anySun(dice));
    return scene;
}

} // namespace shadowlab::student
