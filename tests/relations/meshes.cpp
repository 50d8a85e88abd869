// The same surfaces written otherwise, or with others that cannot matter: the same picture.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"
#include "tests/relations/relation.h"
#include "tests/support/scenes.h"

namespace shadowlab::relations {

namespace {

/// Adds one triangle with vertices of its own.
void addTriangle(scene::Mesh& to, const std::array<vec3, 3>& positions, const std::array<vec3, 3>& normals) {
    const auto first = static_cast<std::uint32_t>(to.positionsMesh.size());
    to.positionsMesh.insert(to.positionsMesh.end(), positions.begin(), positions.end());
    to.normalsMesh.insert(to.normalsMesh.end(), normals.begin(), normals.end());
    to.triangles.emplace_back(first, first + 1, first + 2);
    to.parts = {{"", 0, static_cast<std::uint32_t>(to.triangles.size())}};
}
void addTriangle(scene::Mesh& to, const scene::Mesh& from, const uvec3& t) {
    addTriangle(to, {from.positionsMesh[t.x], from.positionsMesh[t.y], from.positionsMesh[t.z]},
                {from.normalsMesh[t.x], from.normalsMesh[t.y], from.normalsMesh[t.z]});
}

Comparison samePicture(const scene::Scene& a, const scene::Scene& b, Painter& painter, Gate gate) {
    const Picture expected = painter.paint(a);
    return compare(expected, painter.paint(b), gate);
}

Comparison inAnotherOrder(const Recipe& recipe, Painter& painter) {
    Choice choice(recipe);
    const scene::Scene scene = sceneOf(recipe);
    scene::Scene other = scene;
    for (scene::Object& object : other.objects) {
        std::vector<uvec3> triangles = object.mesh->triangles;
        for (std::size_t i = triangles.size(); i > 1; --i)
            std::swap(triangles[i - 1], triangles[choice(static_cast<unsigned>(i))]);
        scene::Mesh mesh;
        for (const uvec3& t : triangles)
            addTriangle(mesh, *object.mesh, t);
        object.mesh = scene::sharedMesh(std::move(mesh));
    }
    std::reverse(other.objects.begin(), other.objects.end());
    return samePicture(scene, other, painter, Gate::edgesAndTexels);
}

Comparison eachTriangleAlone(const Recipe& recipe, Painter& painter) {
    const scene::Scene scene = sceneOf(recipe);
    scene::Scene other = scene;
    other.objects.clear();
    for (const scene::Object& object : scene.objects)
        for (const uvec3& t : object.mesh->triangles) {
            scene::Mesh mesh;
            addTriangle(mesh, *object.mesh, t);
            other.objects.push_back(object);
            other.objects.back().name = "triangle" + std::to_string(other.objects.size());
            other.objects.back().mesh = scene::sharedMesh(std::move(mesh));
        }
    return samePicture(scene, other, painter, Gate::edgesAndTexels);
}

Comparison asOneMesh(const Recipe& recipe, Painter& painter) {
    const scene::Scene scene = sceneOf(recipe);
    scene::Scene other = scene;
    scene::Mesh all;
    std::vector<scene::MeshPart> parts;
    scene::Object together = scene.objects[0];
    together.partMaterials.clear();
    for (const scene::Object& object : scene.objects) {
        const auto first = static_cast<std::uint32_t>(all.triangles.size());
        scene::Mesh placed = *object.mesh;
        for (vec3& position : placed.positionsMesh) // sums of numbers on the grid: exact
            position = vec3(dvec3(scene::worldFromMesh(object) * dvec4(dvec3(position), 1)));
        for (const uvec3& t : placed.triangles)
            addTriangle(all, placed, t);
        parts.push_back({"", first, static_cast<std::uint32_t>(all.triangles.size()) - first});
        together.partMaterials.push_back(object.partMaterials[0]);
    }
    all.parts = parts;
    together.mesh = scene::sharedMesh(std::move(all));
    together.worldFromObject = dmat4(1.0);
    other.objects = {together};
    return samePicture(scene, other, painter, Gate::edgesAndTexels);
}

Comparison cutIntoFour(const Recipe& recipe, Painter& painter) {
    const scene::Scene scene = sceneOf(recipe);
    scene::Scene other = scene;
    for (scene::Object& object : other.objects) {
        scene::Mesh mesh;
        const scene::Mesh& old = *object.mesh;
        for (const uvec3& t : old.triangles) {
            std::array<vec3, 6> p, n; // corners, and the middles after them: on half the grid, and exact
            for (int i = 0; i < 3; ++i) {
                const std::uint32_t a = t[i], b = t[(i + 1) % 3];
                const auto at = static_cast<std::size_t>(i);
                p[at] = old.positionsMesh[a], p[at + 3] = (old.positionsMesh[a] + old.positionsMesh[b]) / 2.0f;
                // Not of length one: so all points of the triangle keep their normal.
                n[at] = old.normalsMesh[a], n[at + 3] = (old.normalsMesh[a] + old.normalsMesh[b]) / 2.0f;
            }
            addTriangle(mesh, {p[0], p[3], p[5]}, {n[0], n[3], n[5]});
            addTriangle(mesh, {p[3], p[1], p[4]}, {n[3], n[1], n[4]});
            addTriangle(mesh, {p[5], p[4], p[2]}, {n[5], n[4], n[2]});
            addTriangle(mesh, {p[3], p[4], p[5]}, {n[3], n[4], n[5]});
        }
        object.mesh = scene::sharedMesh(std::move(mesh));
    }
    return samePicture(scene, other, painter, Gate::edgesAndTexels);
}

Comparison everythingTwice(const Recipe& recipe, Painter& painter) {
    const scene::Scene scene = sceneOf(recipe);
    scene::Scene other = scene;
    for (scene::Object object : scene.objects) {
        object.name += "again";
        other.objects.push_back(object);
    }
    return samePicture(scene, other, painter, Gate::exact);
}

dvec3 backward(const scene::Camera& camera) { return glm::normalize(camera.positionWorld - camera.targetWorld); }

/// Behind the eye, and so far below everything that light from above takes its shadow farther down.
Comparison somethingFarAway(const Recipe& recipe, Painter& painter) {
    const scene::Scene scene = sceneOf(recipe);
    scene::Scene other = scene;
    const dvec3 place = 1024.0 * backward(scene.camera) - dvec3(0, 2048, 0);
    testing::addObject(other, scene::makeBox({1, 1, 1}), testing::translation(glm::round(place)));
    return samePicture(scene, other, painter, Gate::edgesAndTexels);
}

/// The picture is the same, and where volumes end need not be: they end behind whatever could receive a shadow.
Comparison somethingBehindTheEye(const Recipe& recipe, Painter& painter) {
    const scene::Scene scene = sceneOf(recipe);
    scene::Scene other = scene;
    const dvec3 place = scene.camera.positionWorld + 2.0 * backward(scene.camera);
    testing::addObject(other, scene::makeBox({0.5, 0.5, 0.5}), testing::translation(place)).castsShadow = false;
    return samePicture(scene, other, painter, Gate::edges);
}

bool solvesNoRoom(const Traits& traits) { return !traits.solvesRoom; }
/// Who serves flat faces alone decides by the mesh what is one: a triangle alone is, and beside a large floor no small one is.
bool servesAll(const Traits& traits) { return traits.servesAll && !traits.solvesRoom; }

} // namespace

std::vector<Relation> meshRelations() {
    return {
        {"in-another-order", "triangles and objects in another order: the same picture", solvesNoRoom, inAnotherOrder},
        {"each-triangle-alone", "each triangle its own object: the same picture", servesAll, eachTriangleAlone},
        {"as-one-mesh", "all objects in one mesh: the same picture", servesAll, asOneMesh},
        {"cut-into-four", "each triangle cut into four: the same picture", solvesNoRoom, cutIntoFour},
        {"everything-twice", "each object twice at its place: the same bytes", solvesNoRoom, everythingTwice},
        {"something-far-away", "a box that is far from all shadows: the same picture", solvesNoRoom, somethingFarAway},
        {"behind-the-eye", "a box there that casts no shadow: the same picture", solvesNoRoom, somethingBehindTheEye},
    };
}

} // namespace shadowlab::relations
