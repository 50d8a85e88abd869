// SPDX-License-Identifier: MIT
#include "tests/relations/recipe.h"

#include <cmath>
#include <fstream>
#include <iomanip>

#include "techniques/foundation/scene/json/write_scene.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"
#include "tests/support/scenes.h"

namespace shadowlab::relations {

namespace {

constexpr ivec3 kSmallest{384, 384, 384}; // steps: three eighths of a metre
constexpr dvec3 kLightWorld{1.5, 5.0, 2.0};
constexpr double kFloor = 10; // metres along each side

dvec3 metres(const ivec3& steps) { return dvec3(steps) * kGrid; }
dvec3 onGrid(const dvec3& place) { return glm::round(place / kGrid) * kGrid; }

Solid solidOf(const SolidRecipe& recipe) {
    const ivec3 size = (kSmallest + recipe.size) / 2 * 2;
    switch (recipe.kind) {
    case SolidKind::box: return makeBoxSolid(size);
    case SolidKind::ball: return makeBallSolid(size);
    case SolidKind::prism: return makePrismSolid(size, recipe.shape);
    default: return makeHullSolid(size, recipe.shape);
    }
}

void addMaterials(scene::Scene& scene) {
    for (const float grey : {0.8f, 0.6f, 0.4f}) {
        scene.materials.emplace_back();
        scene.materials.back().diffuse = vec3(grey, grey, 0.9f * grey);
        if (scene.materials.size() > 1) scene.materials.back().name = "grey" + std::to_string(scene.materials.size());
    }
}

/// Does the ray from `place` along `way` (up to its end, or without one) meet the object? Near misses count.
bool meets(const scene::Object& object, const dvec3& place, const dvec3& way, bool ends) {
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    for (const uvec3& t : object.mesh->triangles) {
        dvec3 corner[3];
        for (int i = 0; i < 3; ++i)
            corner[i] = dvec3(worldFromMesh * dvec4(dvec3(object.mesh->positionsMesh[t[i]]), 1));
        const dvec3 u = corner[1] - corner[0], v = corner[2] - corner[0], p = glm::cross(way, v);
        const double determinant = glm::dot(u, p);
        if (determinant == 0) continue;
        const dvec3 from = place - corner[0], q = glm::cross(from, u);
        const double a = glm::dot(from, p) / determinant, b = glm::dot(way, q) / determinant,
                     along = glm::dot(v, q) / determinant;
        constexpr double kMargin = 1e-3; // of the triangle: the near plane is a rectangle, not a point
        if (a >= -kMargin && b >= -kMargin && a + b <= 1 + kMargin && along > 0 && (!ends || along < 1)) return true;
    }
    return false;
}

bool isInside(const scene::Scene& scene, const dvec3& place) {
    for (const scene::Object& object : scene.objects) {
        const scene::Bounds bounds = scene::boundsWorld(object);
        // A little room around: a light that touches a face, or an eye in one, is a hard case, not a random scene.
        constexpr double kRoom = 0.0625;
        if (glm::all(glm::greaterThan(place, bounds.lowerWorld - kRoom)) &&
            glm::all(glm::lessThan(place, bounds.upperWorld + kRoom)))
            return true;
    }
    return false;
}

std::string meshText(const scene::Object& object) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::setprecision(17);
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    for (const vec3& position : object.mesh->positionsMesh) {
        const dvec4 place = worldFromMesh * dvec4(dvec3(position), 1);
        text << "v " << place.x << " " << place.y << " " << place.z << "\n";
    }
    const bool mirrored = scene::isMirrored(object);
    for (const uvec3& t : object.mesh->triangles)
        text << "f " << t.x + 1 << " " << (mirrored ? t.z : t.y) + 1 << " " << (mirrored ? t.y : t.z) + 1 << "\n";
    return text.str();
}

} // namespace

std::ostream& operator<<(std::ostream& stream, const Recipe& recipe) {
    for (const SolidRecipe& solid : recipe.solids)
        stream << (solid.kind == SolidKind::box     ? "box"
                   : solid.kind == SolidKind::ball  ? "ball"
                   : solid.kind == SolidKind::prism ? "prism "
                                                    : "hull ")
               << (solid.kind >= SolidKind::prism ? std::to_string(solid.shape) : "") << " at " << solid.place.x << ","
               << solid.place.y << "," << solid.place.z << " of " << solid.size.x << "," << solid.size.y << ","
               << solid.size.z << "; ";
    for (const LightRecipe& light : recipe.lights)
        stream << (light.kind == LightKind::lamp  ? "lamp"
                   : light.kind == LightKind::sun ? "sun"
                                                  : "spot")
               << " at " << light.place.x << "," << light.place.y << "," << light.place.z << "; ";
    const EyeRecipe& eye = recipe.eye;
    return stream << "eye " << eye.aroundDegrees << " degrees around, " << eye.height << " high, " << eye.distance
                  << " away, to " << eye.target.x << "," << eye.target.y << "," << eye.target.z << "; chance "
                  << recipe.chance;
}

scene::Scene sceneOf(const Recipe& recipe) {
    scene::Scene scene;
    scene.name = "relations";
    addMaterials(scene);
    scene.ambient = vec3(0.125f);
    scene.background = vec3(0.0625f);
    testing::addObject(scene, scene::makeQuad({kFloor, kFloor}));
    scene.objects.back().name = "floor";
    for (const SolidRecipe& one : recipe.solids) {
        const Solid solid = solidOf(one);
        int lowest = 0;
        for (const ivec3& corner : solid.corners)
            lowest = std::min(lowest, corner.y);
        const dvec3 place = metres(ivec3(one.place.x, std::max(0, one.place.y) - lowest, one.place.z));
        scene::Object& object =
            testing::addObject(scene, meshOf(solid, one.kind == SolidKind::ball), testing::translation(place));
        object.partMaterials.assign(1, static_cast<std::uint32_t>(scene.objects.size() % scene.materials.size()));
    }
    for (const LightRecipe& one : recipe.lights) {
        const dvec3 place = kLightWorld + metres(one.place);
        const bool isSun = one.kind == LightKind::sun;
        scene.lights.push_back(isSun ? testing::directionalLight(-place) : testing::pointLight(place));
        scene::Light& light = scene.lights.back();
        light.name = "light" + std::to_string(scene.lights.size());
        if (one.kind == LightKind::spot) {
            light.type = scene::LightType::spot;
            light.directionWorld = glm::normalize(-place);
            light.coneDegrees = 70; // less than the floor: there is light, and there is none
            light.edgeDegrees = 10;
        }
        // Bright enough to see, and all of them together below clipping: else a difference could hide in white.
        const double share = 1.0 / static_cast<double>(recipe.lights.size());
        light.intensity = (isSun ? 1.0 : 16.0) * share;
    }
    const double angle = recipe.eye.aroundDegrees * M_PI / 180, distance = 5 + recipe.eye.distance * kGrid;
    scene.camera.positionWorld =
        onGrid({distance * std::sin(angle), 2.5 + recipe.eye.height * kGrid, distance * std::cos(angle)});
    scene.camera.targetWorld = dvec3(0, 0.5, 0) + metres(recipe.eye.target);
    scene.camera.fovYDegrees = 50;
    scene.camera.near = 0x1p-5;
    return scene;
}

bool standsFree(const scene::Scene& scene) {
    std::vector<dvec3> eyes = {scene.camera.positionWorld};
    for (const dvec3& corner : scene::viewCorners(scene.camera, 1.25, scene.camera.near))
        eyes.push_back(corner);
    if (isInside(scene, eyes[0])) return false;
    for (const scene::Light& light : scene.lights) {
        const dvec4 place = scene::homogeneousPositionWorld(light);
        if (place.w == 1 && isInside(scene, dvec3(place))) return false;
        for (const dvec3& eye : eyes)
            for (const scene::Object& object : scene.objects)
                if (meets(object, eye, dvec3(place) - eye * place.w, place.w == 1)) return false;
    }
    return true;
}

std::filesystem::path writeScene(const scene::Scene& scene, const std::filesystem::path& folder,
                                 const std::string& name) {
    std::filesystem::create_directories(folder);
    scene::Scene written = scene;
    for (scene::Object& object : written.objects) {
        object.source = {};
        object.source.mesh = std::filesystem::weakly_canonical(folder) / (name + "-" + object.name + ".obj");
        object.source.material = written.materials[object.partMaterials[0]].name;
        std::ofstream(object.source.mesh) << meshText(object);
    }
    const std::filesystem::path file = folder / (name + ".json");
    std::ofstream(file) << scene::sceneText(written, written.camera, folder);
    return file;
}

} // namespace shadowlab::relations
