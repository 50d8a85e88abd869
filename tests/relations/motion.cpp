// Scene, eye and lights together somewhere else, turned, larger, or seen in a mirror: the same picture.
// SPDX-License-Identifier: MIT
#include <glm/gtc/matrix_transform.hpp>

#include "tests/relations/relation.h"

namespace shadowlab::relations {

namespace {

dvec3 direction(const dmat4& matrix, const dvec3& way) { return glm::normalize(dvec3(matrix * dvec4(way, 0))); }
dvec3 place(const dmat4& matrix, const dvec3& point) { return dvec3(matrix * dvec4(point, 1)); }

scene::Scene transformed(scene::Scene scene, const dmat4& matrix) {
    scene.camera.positionWorld = place(matrix, scene.camera.positionWorld);
    scene.camera.targetWorld = place(matrix, scene.camera.targetWorld);
    scene.camera.upWorld = direction(matrix, scene.camera.upWorld);
    for (scene::Light& light : scene.lights) {
        light.positionWorld = place(matrix, light.positionWorld);
        light.directionWorld = direction(matrix, light.directionWorld);
    }
    for (scene::Object& object : scene.objects)
        object.worldFromObject = matrix * object.worldFromObject;
    return scene;
}

Comparison samePicture(const Recipe& recipe, Painter& painter, const dmat4& matrix, Gate gate) {
    const scene::Scene scene = sceneOf(recipe);
    const Picture here = painter.paint(scene);
    return compare(here, painter.paint(transformed(scene, matrix)), gate);
}

Comparison moved(const Recipe& recipe, Painter& painter) {
    Choice choice(recipe);
    const dvec3 offset(choice(256) - 128.0, choice(256) - 128.0, choice(256) - 128.0);
    return samePicture(recipe, painter, glm::translate(dmat4(1.0), offset), Gate::edges);
}

/// Turns by right angles have matrices of 0, 1 and -1: places stay on their grid.
Comparison turnedByRightAngles(const Recipe& recipe, Painter& painter) {
    Choice choice(recipe);
    dmat4 matrix(1.0);
    for (unsigned turns = 1 + choice(3); turns > 0; --turns) {
        const int u = static_cast<int>(choice(3)), v = (u + 1) % 3;
        dmat4 turn(1.0);
        turn[u][u] = turn[v][v] = 0;
        turn[u][v] = 1;
        turn[v][u] = -1;
        matrix = turn * matrix;
    }
    return samePicture(recipe, painter, matrix, Gate::edgesAndTexels);
}

Comparison turnedByAnyAngle(const Recipe& recipe, Painter& painter) {
    Choice choice(recipe);
    const dvec3 axis(choice(200) - 100.0, choice(200) + 1.0, choice(200) - 100.0);
    const dmat4 matrix = glm::rotate(dmat4(1.0), (1 + choice(359)) * M_PI / 180, glm::normalize(axis));
    return samePicture(recipe, painter, matrix, Gate::edgesAndTexels);
}

/// By a power of two, all numbers keep their digits. (A direction made unit again would not.)
Comparison scaledByPowersOfTwo(const Recipe& recipe, Painter& painter) {
    Choice choice(recipe);
    const double factors[] = {0x1p-6, 0x1p3, 0x1p10}, factor = factors[choice(3)];
    scene::Scene scene = sceneOf(recipe);
    const Picture here = painter.paint(scene);
    scene.camera.positionWorld *= factor;
    scene.camera.targetWorld *= factor;
    scene.camera.near *= factor;
    for (scene::Light& light : scene.lights) {
        light.positionWorld *= factor;
        if (light.type != scene::LightType::directional) light.intensity *= factor * factor; // spread over an area
    }
    for (scene::Object& object : scene.objects)
        object.worldFromObject = glm::scale(dmat4(1.0), dvec3(factor)) * object.worldFromObject;
    // All levels count; yet a side of a volume that begins in the very edge of what is seen is one pixel in some millions that
    // llvmpipe (not softpipe) decides otherwise.
    Comparison result = compare(here, painter.paint(scene), Gate::exact);
    result.gate = Gate::edges;
    return result;
}

Comparison inAMirror(const Recipe& recipe, Painter& painter) {
    Choice choice(recipe);
    dvec3 factors(1.0);
    factors[static_cast<int>(choice(3))] = -1;
    const scene::Scene scene = sceneOf(recipe);
    const Picture here = painter.paint(scene);
    const Picture there = painter.paint(transformed(scene, glm::scale(dmat4(1.0), factors)));
    return compare(here, rearranged(there, kSize, [](ivec2 p) { return ivec2(kSize.x - 1 - p.x, p.y); }), Gate::edges);
}

Comparison upsideDown(const Recipe& recipe, Painter& painter) {
    scene::Scene scene = sceneOf(recipe);
    const Picture here = painter.paint(scene);
    scene.camera.upWorld = -scene.camera.upWorld;
    const Picture there = painter.paint(scene);
    return compare(here, rearranged(there, kSize, [](ivec2 p) { return kSize - 1 - p; }), Gate::edges);
}

Comparison onItsSide(const Recipe& recipe, Painter& painter) {
    constexpr ivec2 kSquare{144, 144}; // as many pixels as the others have
    scene::Scene scene = sceneOf(recipe);
    const Picture here = painter.paint(scene, kSquare);
    const dvec3 backward = glm::normalize(scene.camera.positionWorld - scene.camera.targetWorld);
    scene.camera.upWorld = glm::normalize(glm::cross(scene.camera.upWorld, backward)); // what was right is up
    const Picture there = painter.paint(scene, kSquare);
    return compare(here, rearranged(there, kSquare, [](ivec2 p) { return ivec2(p.y, kSquare.x - 1 - p.x); }),
                   Gate::edges);
}

} // namespace

std::vector<Relation> motionRelations() {
    return {
        {"moved", "everything moved by up to 128 m each way: the same picture", {}, moved},
        {"turned-by-right-angles", "everything turned by right angles: the same picture", {}, turnedByRightAngles},
        {"turned-by-any-angle", "everything turned about any axis: the same picture", {}, turnedByAnyAngle},
        {"scaled-by-powers-of-two", "everything 2^-6, 2^3 or 2^10 times as large: the same", {}, scaledByPowersOfTwo},
        {"in-a-mirror", "everything mirrored: the mirrored picture", {}, inAMirror},
        {"upside-down", "the eye rolled by half a turn: so is the picture", {}, upsideDown},
        {"on-its-side", "the eye rolled by a quarter: so is the picture", {}, onItsSide},
    };
}

} // namespace shadowlab::relations
