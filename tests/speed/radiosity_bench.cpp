// What radiosity costs and how exact it is.
//
//   ninja -C build/release radiosity_bench
//   build/release/tests/radiosity_bench [--plots FOLDER] growth [COUNT]...    (500 1000 2000 5000)
//   build/release/tests/radiosity_bench [--plots FOLDER] solvers [COUNT]      (2000)
//   build/release/tests/radiosity_bench [--plots FOLDER] hemicube [COUNT]     (1000)
//
// To be run from the folder that holds assets/. COUNT is how many patches there are at most before they are cut where things touch.
//   growth    time, memory and what is wrong with the radiosity, against the number of patches (radiosity_growth.cpp)
//   solvers   what each solver knows of its error and what the error is, against time (radiosity_solvers.cpp)
//   hemicube  form factors by drawing beside exact ones, at several sizes of the picture (radiosity_hemicube.cpp)
// SPDX-License-Identifier: MIT
#include "tests/speed/radiosity_bench.h"

#include <cstdio>
#include <string>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/error.h"
#include "techniques/foundation/scene/load.h"
#include "techniques/foundation/trace/bvh_build.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/radiosity/contacts.h"
#include "techniques/radiosity/solvers.h"

namespace shadowlab::radiosity {

CornellRoom::CornellRoom(std::size_t mostPatches) {
    const scene::Snapshot scene =
        scene::loadScene("assets/scenes/cornell-room.json", {.assetsRoot = {}, .allowed = {}, .limits = {}});
    const trace::WorldTriangles world = trace::worldTriangles(*scene);
    faces = facesOf(*scene, world);
    bvh_ = trace::buildBvh(world.triangles);
    patches = cutAtContacts(faces, cutIntoPatches(faces, sizeForBudget(faces, mostPatches)));
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

int main(int count, char** arguments) {
    using namespace shadowlab;
    try {
        std::vector<std::string> words(arguments + 1, arguments + count);
        std::string plots;
        if (words.size() >= 2 && words[0] == "--plots") {
            plots = words[1];
            words.erase(words.begin(), words.begin() + 2);
        }
        std::vector<std::size_t> counts;
        for (std::size_t i = 1; i < words.size(); ++i) {
            if (words[i].size() > 6 || words[i].find_first_not_of("0123456789") != std::string::npos)
                throw Error(ExitStatus::usage, "'" + words[i] + "' is no number of patches; give one like 2000");
            counts.push_back(std::stoul(words[i]));
        }
        std::printf("radiosity_bench");
        for (int i = 1; i < count; ++i)
            std::printf(" %s", arguments[i]);
        std::printf("   (%d threads)\n", trace::threadCount());
        const auto only = [&](std::size_t otherwise) { return counts.empty() ? otherwise : counts.front(); };
        const std::string part = words.empty() ? "" : words[0];
        if (part == "growth")
            radiosity::benchGrowth(counts.empty() ? std::vector<std::size_t>{500, 1000, 2000, 5000} : counts, plots);
        else if (part == "solvers")
            radiosity::benchSolvers(only(2000), plots);
        else if (part == "hemicube")
            radiosity::benchHemicube(only(1000), plots);
        else
            throw Error(ExitStatus::usage, "radiosity_bench [--plots FOLDER] growth|solvers|hemicube [COUNT]...");
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return static_cast<int>(error.status());
    }
}
