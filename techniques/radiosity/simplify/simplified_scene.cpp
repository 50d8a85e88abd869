// SPDX-License-Identifier: MIT
#include "techniques/radiosity/simplify/simplified_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/radiosity/patches/polygon.h"
#include "techniques/radiosity/simplify/inside_out.h"

namespace shadowlab::radiosity {

namespace {

// Meshes of so few triangles would lose their shape for little gain.
constexpr std::size_t kLightMesh = 100;

// The fewest that can bound a roundish body: an octahedron.
constexpr std::size_t kFewestLeft = 8;

// A mesh that would keep more than this share of its triangles stays as it is: it would lose more in shape than the exchange
// gains in speed.
constexpr double kWorthIt = 0.75;

// From cells of an object's own size to 2^-15 of it, so that cell coordinates fit into fifteen bits.
constexpr int kSteps = 60;

// A step before all others, for scenes of so many objects that even cells of their own size leave too many triangles: each becomes
// about a box.
constexpr int kOctants = -1;

/// An object whose mesh is simplified.
struct Heavy {
    Heavy(const scene::Scene& scene, std::size_t number, double size)
        : number(number), object(scene.objects[number]), clusters(object), sceneSize(size) {
        // Cells that contain the whole object leave nothing; these steps are skipped.
        if (clusters.size() > 0) firstStep = std::max(0, static_cast<int>(4 * std::log2(sceneSize / clusters.size())));
        lastStep = firstStep + kSteps;
    }

    std::size_t number;
    const scene::Object& object;
    VertexClusters clusters;
    double sceneSize;
    int firstStep = 0, lastStep = 0;        ///< range of steps that are tried
    std::map<int, std::size_t> roughCounts; ///< by step
    std::optional<ClusteredMesh> coarse;    ///< nothing: the mesh stays as it is

    [[nodiscard]] dvec3 cell(int step) const { return step == kOctants ? clusters.octant() : dvec3(sceneSize * std::exp2(-0.25 * step)); }
    [[nodiscard]] bool isEnough(std::size_t triangles, int step) const {
        const bool isFlatEnough = step == kOctants && !object.mesh->outward; // two triangles stand for a flat sheet
        return triangles >= (isFlatEnough ? 2 : kFewestLeft);
    }
    [[nodiscard]] std::size_t original() const { return object.mesh->triangles.size(); }
    [[nodiscard]] std::size_t count() const { return coarse ? coarse->triangles.size() : original(); }
    /// About how many triangles remain with cells of that step, or of the next finer step that leaves enough.
    std::size_t roughCount(int step) {
        for (step = std::max(step, firstStep); step <= lastStep; ++step) {
            const auto [entry, isNew] = roughCounts.try_emplace(step, 0);
            if (isNew) entry->second = clusters.roughCount(cell(step));
            if (entry->second >= kFewestLeft) return entry->second;
        }
        return original();
    }
    void simplify(int step) {
        if (step == kOctants) coarse = clusters.clustered(cell(step));
        if (step != kOctants || !isEnough(coarse->triangles.size(), step))
            for (step = std::clamp(step, firstStep, lastStep); step <= lastStep; ++step) {
                coarse = clusters.clustered(cell(step));
                if (isEnough(coarse->triangles.size(), step)) break;
            }
        const auto left = static_cast<double>(coarse->triangles.size());
        if (step > lastStep || left > kWorthIt * static_cast<double>(original())) coarse.reset();
    }
};

scene::Mesh meshOf(const scene::Object& object, const ClusteredMesh& coarse) {
    const scene::Mesh& original = *object.mesh;
    const dmat3 meshFromMetres = glm::inverse(dmat3(object.worldFromObject));
    scene::Mesh mesh;
    mesh.originObject = original.originObject;
    mesh.outward = original.outward;
    for (const dvec3& position : coarse.positions)
        mesh.positionsMesh.emplace_back(meshFromMetres * position);
    // Placeholders; withNormals() below computes them.
    mesh.normalsMesh.assign(mesh.positionsMesh.size(), vec3(0, 1, 0));
    mesh.triangles = coarse.triangles;
    std::uint32_t first = 0;
    for (std::uint32_t part = 0; part < original.parts.size(); ++part) {
        std::uint32_t count = 0;
        while (first + count < coarse.parts.size() && coarse.parts[first + count] == part)
            ++count;
        mesh.parts.push_back({original.parts[part].materialName, first, count, false});
        first += count;
    }
    return scene::withNormals(mesh, scene::NormalMode::smooth);
}

/// Of each part, m^2.
std::vector<double> partAreas(const scene::Mesh& mesh, const dmat4& worldFromObject) {
    const dmat3 metresFromMesh(worldFromObject);
    std::vector<double> areas;
    for (const scene::MeshPart& part : mesh.parts) {
        double& area = areas.emplace_back(0);
        for (std::uint32_t t = part.firstTriangle; t < part.firstTriangle + part.triangleCount; ++t) {
            const uvec3 corners = mesh.triangles[t];
            const auto corner = [&](int i) { return metresFromMesh * dvec3(mesh.positionsMesh[corners[i]]); };
            area += glm::length(areaVector({corner(0), corner(1), corner(2)}));
        }
    }
    return areas;
}

std::vector<SimplifiedScene::Areas> areasOf(const scene::Mesh& original, const scene::Mesh& coarse, const dmat4& worldFromObject) {
    std::vector<SimplifiedScene::Areas> areas;
    const std::vector<double> before = partAreas(original, worldFromObject), after = partAreas(coarse, worldFromObject);
    for (std::size_t part = 0; part < before.size(); ++part)
        areas.push_back({before[part], after[part]});
    return areas;
}

std::shared_ptr<const scene::Mesh> withoutTriangles(const scene::Mesh& mesh) {
    auto empty = std::make_shared<scene::Mesh>();
    empty->originObject = mesh.originObject;
    for (const scene::MeshPart& part : mesh.parts)
        empty->parts.push_back({part.materialName, 0, 0, false});
    return empty;
}

/// The last step, counted from `first`, before the count exceeds `most`; at most `finest`.
template <typename Count>
int lastStepWithin(int first, int finest, std::size_t most, const Count& countAt) {
    int step = first;
    while (step < finest && countAt(step + 1) <= most)
        ++step;
    return step;
}

} // namespace

SimplifiedScene simplifiedScene(const scene::Scene& scene, std::size_t mostSides, std::span<const std::uint8_t> sidesOfObject) {
    SimplifiedScene answer;
    const auto sidesOf = [&](std::size_t object) { return sidesOfObject.empty() ? std::size_t{1} : std::size_t{sidesOfObject[object]}; };
    std::size_t sidesBefore = 0;
    auto changed = std::make_shared<scene::Scene>(scene);
    scene::Bounds bounds;
    for (std::size_t o = 0; o < changed->objects.size(); ++o) {
        scene::Object& object = changed->objects[o];
        if (object.emitterOfLight >= 0) {
            object.mesh = withoutTriangles(*object.mesh);
            changed->revisions.geometry = scene::newRevision();
        }
        answer.trianglesBefore += object.mesh->triangles.size();
        sidesBefore += sidesOf(o) * object.mesh->triangles.size();
        if (!object.isFurtherPiece) bounds.include(scene::boundsWorld(object)); // others may lie in another country
    }
    answer.trianglesAfter = answer.trianglesBefore;
    answer.cornersOfObject.resize(scene.objects.size());
    answer.areasOfObject.resize(scene.objects.size());
    answer.scene = changed;
    if (sidesBefore <= mostSides) return answer;

    std::vector<Heavy> heavy;
    std::size_t kept = 0;
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const std::size_t triangles = changed->objects[o].mesh->triangles.size();
        if (triangles > kLightMesh)
            heavy.emplace_back(scene, o, glm::length(bounds.upperWorld - bounds.lowerWorld));
        else
            kept += sidesOf(o) * triangles;
    }
    if (heavy.empty()) return answer;

    // roughCount() is cheap and finds nearly the right step; the exact counts then decide whether cells may be finer.
    const auto sum = [&](const auto& countOf) {
        std::vector<std::size_t> counts(heavy.size());
        trace::parallelFor(heavy.size(), [&](std::size_t i) { counts[i] = sidesOf(heavy[i].number) * countOf(heavy[i]); });
        std::size_t all = kept;
        for (const std::size_t count : counts)
            all += count;
        return all;
    };
    const auto simplified = [&](int step) {
        return sum([&](Heavy& one) {
            one.simplify(step);
            return one.count();
        });
    };
    const auto rough = [&](int step) { return sum([&](Heavy& one) { return one.roughCount(step); }); };
    const int finest = std::ranges::max_element(heavy, {}, &Heavy::lastStep)->lastStep;
    int step = lastStepWithin(0, finest, mostSides, rough);
    while (step > kOctants && simplified(step) > mostSides)
        --step;
    if (step > kOctants) step = lastStepWithin(step, finest, mostSides, simplified);
    simplified(step);
    for (const Heavy& one : heavy) {
        const dvec3 cell = one.cell(step);
        answer.cellMetres = std::max({answer.cellMetres, cell.x, cell.y, cell.z});
    }

    for (Heavy& one : heavy)
        if (one.coarse && one.object.mesh->outward) orientOutward(*one.coarse, scene::isMirrored(one.object));
    for (const Heavy& one : heavy)
        if (one.coarse) {
            const scene::Mesh coarse = meshOf(one.object, *one.coarse);
            answer.areasOfObject[one.number] = areasOf(*one.object.mesh, coarse, one.object.worldFromObject);
            changed->objects[one.number].mesh = std::make_shared<const scene::Mesh>(coarse);
        }
    changed->revisions.geometry = scene::newRevision();
    answer.trianglesAfter = 0;
    std::vector<std::uint32_t> firstOfObject;
    std::uint32_t first = 0;
    for (const scene::Object& object : changed->objects) {
        firstOfObject.push_back(first);
        first += static_cast<std::uint32_t>(object.mesh->triangles.size());
        answer.trianglesAfter += object.mesh->triangles.size();
    }
    for (const Heavy& one : heavy)
        if (one.coarse)
            answer.cornersOfObject[one.number] =
                cornerPlaces(*one.object.mesh, one.clusters, *one.coarse, firstOfObject[one.number]);
    return answer;
}

} // namespace shadowlab::radiosity
