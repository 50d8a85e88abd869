// SPDX-License-Identifier: MIT
#include "tests/speed/cornell_room.h"

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/trace/bvh/bvh_build.h"
#include "techniques/radiosity/patches/contacts.h"
#include "techniques/radiosity/solvers/solvers.h"

namespace shadowlab::radiosity {

namespace {

std::vector<Patch> quartered(const std::vector<Patch>& patches) {
    std::vector<Patch> all;
    for (const Patch& patch : patches) {
        const Polygon& q = patch.polygon; // a quad: the room has no others
        for (std::size_t i = 0; i < 4; ++i) {
            Patch piece = patch;
            piece.polygon = {q[i], 0.5 * (q[i] + q[(i + 1) % 4]), patch.centre, 0.5 * (q[i] + q[(i + 3) % 4])};
            piece.centre = centroid(piece.polygon);
            piece.area = glm::length(areaVector(piece.polygon));
            all.push_back(piece);
        }
    }
    return all;
}

} // namespace

CornellRoom::CornellRoom(std::size_t mostPatches, int halvings) {
    const scene::Snapshot scene =
        scene::loadScene("assets/scenes/cornell-room.json", {.assetsRoot = {}, .allowed = {}, .limits = {}});
    const trace::WorldTriangles world = trace::worldTriangles(*scene);
    faces = facesOf(*scene, world);
    bvh_ = trace::buildBvh(world.triangles);
    patches = cutIntoPatches(faces, sizeForBudget(faces, mostPatches));
    for (int i = 0; i < halvings; ++i)
        patches = quartered(patches);
    patches = cutAtContacts(faces, patches);
    std::vector<std::uint8_t> casts;
    for (const std::uint32_t object : world.objects)
        casts.push_back(scene->objects[object].castsShadow || scene->objects[object].emitterOfLight >= 0 ? 1 : 0);
    occlusion.emplace(faces, *bvh_, casts);
    for (const Patch& patch : patches) {
        const scene::Material& material = scene->materials[faces.all[patch.face].material];
        emission.push_back(glm::pi<double>() * dvec3(material.emission));
        reflectance.emplace_back(material.diffuse);
    }
}

std::vector<double> CornellRoom::areas() const {
    std::vector<double> areas;
    for (const Patch& patch : patches)
        areas.push_back(patch.area);
    return areas;
}

std::vector<dvec3> solved(const Problem& problem) {
    const auto solver = makeSolver(SolverKind::conjugateGradients, problem);
    if (!solve(*solver, 1e-6, 1000)) throw Error(ExitStatus::bug, "conjugate gradients did not solve the room");
    return solver->radiosity();
}

} // namespace shadowlab::radiosity
