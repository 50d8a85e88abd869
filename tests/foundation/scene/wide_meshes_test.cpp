// Meshes that floats about one origin do not hold: coordinates of a country, vertices left over at its origin, villages far apart. They
// look and are judged like the same mesh at home.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <sstream>

#include "app/lab/handles.h"
#include "techniques/foundation/scene/json/write_scene.h"
#include "techniques/foundation/scene/model/edit_scene.h"
#include "techniques/foundation/scene/model/object_pieces.h"
#include "techniques/foundation/scene/obj/mesh_pieces.h"
#include "techniques/foundation/scene/obj/obj_mesh.h"
#include "techniques/foundation/scene/query/outside_camera.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"
#include "techniques/foundation/trace/judge/exact_visibility.h"
#include "tests/foundation/scene/scene_files.h"
#include "tests/support/brute_force.h"

namespace shadowlab::scene {
namespace {

constexpr dvec3 kCountry(500'000, 120, 5'400'000); // as in a zone of UTM
constexpr double kPost = 0.15;

/// An OBJ text with the corners of its triangles as numbers.
struct Written {
    std::ostringstream text;
    std::vector<dvec3> positions;
    std::vector<uvec3> triangles;
    std::size_t lines = 0;

    Written() { text.precision(17); }
    std::uint32_t vertex(const dvec3& position) {
        text << "v " << position.x << ' ' << position.y << ' ' << position.z << '\n';
        positions.push_back(position);
        ++lines;
        return static_cast<std::uint32_t>(positions.size() - 1);
    }
    void face(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
        triangles.emplace_back(a, b, c);
        ++lines;
    }
    void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << ' ' << d + 1 << '\n';
        triangles.emplace_back(a, b, c);
        triangles.emplace_back(a, c, d);
        ++lines;
    }
};

/// Sixteen posts on a ground of 12 m.
void addVillage(Written& mesh, const dvec3& at) {
    const auto v = [&](double x, double y, double z) { return mesh.vertex(at + dvec3(x, y, z)); };
    const std::uint32_t a = v(-6, 0, -6), b = v(-6, 0, 6), c = v(6, 0, 6), d = v(6, 0, -6);
    mesh.quad(a, b, c, d);
    for (int i = 0; i < 16; ++i) {
        const double x = -4.03 + 2.51 * (i % 4), z = -4.07 + 2.53 * (i / 4), h = 1.0 + 0.37 * (i % 5);
        std::array<std::uint32_t, 8> p{};
        for (std::size_t k = 0; k < 8; ++k)
            p[k] = v(x + (k & 1 ? kPost : 0), k & 2 ? h : 0, z + (k & 4 ? kPost : 0));
        mesh.quad(p[0], p[2], p[3], p[1]), mesh.quad(p[4], p[5], p[7], p[6]), mesh.quad(p[0], p[1], p[5], p[4]);
        mesh.quad(p[2], p[6], p[7], p[3]), mesh.quad(p[0], p[4], p[6], p[2]), mesh.quad(p[1], p[3], p[7], p[5]);
    }
}

enum class Kind { home, country, strayUnused, strayApart, strayOnPost, strayCorner, twoVillages };
constexpr std::array kKinds{Kind::home,        Kind::country,     Kind::strayUnused, Kind::strayApart,
                            Kind::strayOnPost, Kind::strayCorner, Kind::twoVillages};

dvec3 placeOf(Kind kind) { return kind == Kind::home ? dvec3(0) : kCountry; }

Written meshOf(Kind kind) {
    Written mesh;
    addVillage(mesh, placeOf(kind));
    if (kind == Kind::strayUnused) mesh.vertex(dvec3(0));
    if (kind == Kind::strayApart) {
        const std::uint32_t a = mesh.vertex(dvec3(0)), b = mesh.vertex({0, 0, 1}), c = mesh.vertex({1, 0, 0});
        mesh.face(a, b, c);
    }
    if (kind == Kind::strayOnPost) mesh.face(10, 11, mesh.vertex(dvec3(0))); // on an edge of the first post
    if (kind == Kind::strayCorner) mesh.face(8, 9, mesh.vertex(dvec3(0)));   // at its foot
    if (kind == Kind::twoVillages) addVillage(mesh, kCountry + dvec3(100'000, 0, 0));
    return mesh;
}

/// The mesh, moved home.
Snapshot sceneOf(const TempFolder& folder, const Written& mesh, const dvec3& from, const std::string& keys = {}) {
    folder.write("m.obj", mesh.text.str());
    std::ostringstream text;
    text.precision(17);
    text << R"({"camera": {"position": [7, 5, 8], "target": [0, 0.7, 0]},
        "lights": [{"type": "point", "position": [2.3, 6.1, 3.2], "intensity": 150}],
        "objects": [{"mesh": "m.obj", "translate": [)"
         << -from.x << ", " << -from.y << ", " << -from.z << "]" << keys << "}]}";
    return loadScene(folder.write("s.json", text.str()).string(), {});
}

/// What pixels see, by the numbers of the file alone.
class FileJudge {
public:
    FileJudge(const Written& mesh, const dvec3& from) {
        for (const uvec3& t : mesh.triangles)
            triangles_.push_back({0, 0, {mesh.positions[t.x] - from, mesh.positions[t.y] - from, mesh.positions[t.z] - from}});
    }

    /// Nothing where an edge passes so near that the rounding of the floats may decide.
    std::optional<trace::Visibility> at(const Camera& camera, dvec2 pixel, ivec2 size, const dvec3& lightWorld) const {
        bool isClear = true;
        const dvec3 way = rayDirectionWorld(camera, pixel, size);
        const auto seen = first(camera.positionWorld, way, 0, 1e300, triangles_.size(), isClear);
        if (!isClear) return std::nullopt;
        if (!seen) return trace::Visibility::noSurface;
        const dvec3 pointWorld = camera.positionWorld + seen->second * way, toLight = lightWorld - pointWorld;
        dvec3 normal = triangles_[seen->first].normal();
        if (glm::dot(normal, way) > 0) normal = -normal;
        const double cosine = glm::dot(glm::normalize(normal), glm::normalize(toLight));
        if (std::abs(cosine) < 1e-4) return std::nullopt;
        if (cosine < 0) return trace::Visibility::turnedAway;
        const bool blocked = first(pointWorld, toLight, 0, 1, seen->first, isClear).has_value();
        if (!isClear) return std::nullopt;
        return blocked ? trace::Visibility::shadowed : trace::Visibility::lit;
    }

private:
    std::optional<std::pair<std::size_t, double>> first(const dvec3& from, const dvec3& way, double least, double most, std::size_t without,
                                                        bool& isClear) const {
        constexpr double kNear = 1e-4; // of a weight; floats of 20 m are wrong by 1e-6 m, of an edge of 0.15 m by 1e-5
        std::optional<std::pair<std::size_t, double>> found;
        double doubt = 1e300;
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            const auto hit = i == without ? std::nullopt : testing::meets(triangles_[i], from, way);
            if (!hit || hit->along <= least || hit->along >= most) continue;
            if (std::abs(hit->inside) < kNear) doubt = std::min(doubt, hit->along);
            if (hit->inside >= 0 && (!found || hit->along < found->second)) found = {i, hit->along};
        }
        if (doubt < (found ? found->second : most)) isClear = false;
        return found;
    }
    std::vector<testing::WorldTriangle> triangles_;
};

struct Differences {
    int compared = 0, different = 0, shadowed = 0;
};

Differences differences(const Snapshot& scene, const FileJudge& file) {
    const ivec2 size(320, 180);
    const trace::ExactVisibility judge(scene);
    std::mt19937 random(7); // NOLINT: the same pixels in every run
    Differences result;
    for (int i = 0; i < 20'000; ++i) {
        const dvec2 pixel(random() % 320u + 0.5, random() % 180u + 0.5);
        const auto expected = file.at(scene->camera, pixel, size, scene->light(0).positionWorld);
        if (!expected) continue;
        ++result.compared;
        result.shadowed += *expected == trace::Visibility::shadowed;
        result.different += *expected != judge.at(scene->camera, pixel, size, 0);
    }
    return result;
}

/// The mesh as it was kept once: all floats about one origin, in the middle of the box.
Snapshot aboutOneOrigin(const Snapshot& scene, const Written& mesh) {
    auto copy = std::make_shared<Scene>(*scene);
    dvec3 lower(1e300), upper(-1e300);
    for (const uvec3& t : mesh.triangles)
        for (int i = 0; i < 3; ++i)
            lower = glm::min(lower, mesh.positions[t[i]]), upper = glm::max(upper, mesh.positions[t[i]]);
    Mesh kept;
    kept.originObject = chooseOrigin(lower, upper);
    for (const dvec3& position : mesh.positions)
        kept.positionsMesh.emplace_back(position - kept.originObject);
    kept.normalsMesh.assign(kept.positionsMesh.size(), vec3(0, 1, 0));
    kept.triangles = mesh.triangles;
    kept.parts = {{"", 0, static_cast<std::uint32_t>(mesh.triangles.size()), false}};
    copy->objects.resize(1);
    copy->objects.front().mesh = sharedMesh(std::move(kept));
    copy->objects.front().partMaterials = {0};
    return copy;
}

TEST(WideMeshes, TheTruthIsOfTheFilesNumbers) {
    for (const Kind kind : kKinds) {
        const TempFolder folder;
        const Written mesh = meshOf(kind);
        std::vector<dvec3> places{placeOf(kind)};
        if (kind == Kind::twoVillages) places.push_back(kCountry + dvec3(100'000, 0, 0));
        for (const dvec3& place : places) {
            const Differences found = differences(sceneOf(folder, mesh, place), FileJudge(mesh, place));
            EXPECT_EQ(found.different, 0) << static_cast<int>(kind);
            EXPECT_GT(found.compared, 18'000) << static_cast<int>(kind);
            EXPECT_GT(found.shadowed, 150) << static_cast<int>(kind);
        }
    }
}

TEST(WideMeshes, FloatsAboutOneOriginWouldNotDo) {
    for (const Kind kind : {Kind::strayApart, Kind::strayOnPost, Kind::strayCorner}) {
        const TempFolder folder;
        const Written mesh = meshOf(kind);
        const Snapshot kept = aboutOneOrigin(sceneOf(folder, mesh, kCountry), mesh);
        EXPECT_GT(differences(kept, FileJudge(mesh, kCountry)).different, 300) << static_cast<int>(kind);
    }
}

TEST(WideMeshes, AreCutOnlyWhereTheyHaveToBe) {
    const auto pieces = [](Kind kind) {
        const TempFolder folder;
        return sceneOf(folder, meshOf(kind), placeOf(kind))->objects.size();
    };
    EXPECT_EQ(pieces(Kind::home), 1u);
    EXPECT_EQ(pieces(Kind::country), 1u);
    EXPECT_EQ(pieces(Kind::strayUnused), 1u);
    EXPECT_EQ(pieces(Kind::strayApart), 2u);
    EXPECT_EQ(pieces(Kind::strayOnPost), 2u) << "the triangle that reaches out is by itself";
    EXPECT_EQ(pieces(Kind::strayCorner), 2u);
    EXPECT_EQ(pieces(Kind::twoVillages), 2u);
}

// Shadow maps and depth ranges are fitted to boxes of objects.
TEST(WideMeshes, AStrayCornerDoesNotWidenTheBoxOfTheRest) {
    for (const dvec3 place : {dvec3(0), kCountry})
        for (const bool onPost : {false, true}) {
            Written mesh;
            addVillage(mesh, place);
            const std::uint32_t stray = mesh.vertex(place + dvec3(-90'000, 0, -40'000));
            mesh.face(onPost ? 10 : 8, onPost ? 11 : 9, stray);
            const TempFolder folder;
            const Snapshot scene = sceneOf(folder, mesh, place);
            ASSERT_EQ(scene->objects.size(), 2u);
            const Bounds box = boundsWorld(scene->objects[0]);
            EXPECT_NEAR(box.upperWorld.x - box.lowerWorld.x, 12, 1e-3);
            EXPECT_EQ(scene->objects[0].mesh->originObject, scene->objects[1].mesh->originObject) << "or the corners that they share part";
        }
}

TEST(WideMeshes, OrdinaryOnesKeepTheirFloats) {
    const Written mesh = meshOf(Kind::home);
    EXPECT_TRUE(meshPieces(mesh.positions, mesh.triangles, dvec3(0)).origins.empty());
    const TempFolder folder;
    const Mesh read = loadObj(folder.write("m.obj", mesh.text.str()), NormalMode::file, {}).mesh;
    EXPECT_EQ(read.originObject, dvec3(0));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i)
            ASSERT_EQ(read.positionsMesh[read.triangles[t][i]], vec3(mesh.positions[mesh.triangles[t][i]]));
}

TEST(WideMeshes, CornersOfPostsAreAsFineAsAtHome) {
    for (const Kind kind : kKinds) {
        const TempFolder folder;
        const Written mesh = meshOf(kind);
        const Snapshot scene = sceneOf(folder, mesh, placeOf(kind));
        double worst = 0; // of the 132 corners of the first village, to the nearest vertex
        for (std::size_t v = 0; v < 132; ++v) {
            double nearest = 1e300;
            for (const Object& object : scene->objects)
                for (const vec3& position : object.mesh->positionsMesh)
                    nearest = std::min(nearest, glm::length(object.mesh->originObject + dvec3(position) - mesh.positions[v]));
            worst = std::max(worst, nearest);
        }
        EXPECT_LT(worst, kPost * 0x1p-10) << static_cast<int>(kind);
    }
}

/// A strip of quads along x, 0.2 m wide and 1 m long.
Written strip(int metres) {
    Written mesh;
    for (int x = 0; x <= metres; ++x) {
        mesh.vertex({x, 0.1 * (x % 7), 0});
        mesh.vertex({x, 0.1 * (x % 5), 0.2});
        const auto b = static_cast<std::uint32_t>(2 * x);
        if (x > 0) mesh.quad(b - 2, b - 1, b + 1, b);
    }
    return mesh;
}

TEST(WideMeshes, PlacesAreToldApartByAllBits) {
    const double x = 5'399'995.93, next = std::nextafter(x, 6e6);
    const std::vector<dvec3> positions{{1, 2, x}, {1, 2, x + 0.15}, {1, 2, next}, {1, 2, x}, {0.0, 0, 0}, {-0.0, 0, 0}};
    EXPECT_EQ(samePlaces(positions), (std::vector<std::uint32_t>{0, 1, 2, 0, 4, 4}));
}

TEST(WideMeshes, WhatHangsTogetherStaysInOnePiece) {
    const Written mesh = strip(20'000);
    const MeshPieces pieces = meshPieces(mesh.positions, mesh.triangles, dvec3(0));
    EXPECT_EQ(pieces.origins.size(), 1u);
    EXPECT_TRUE(pieces.pieceOf.empty());
    EXPECT_NEAR(pieces.origins.at(0).x, 10'000, 10) << "the middle is the best place";
}

TEST(WideMeshes, PiecesAreFew) {
    Written mesh; // 900 crumbs of 1 cm over 30 km: each origin reaches 160 m
    for (int i = 0; i < 900; ++i) {
        const dvec3 at(1000.0 * (i % 30), 0, 1000.0 * (i / 30));
        const std::uint32_t a = mesh.vertex(at), b = mesh.vertex(at + dvec3(0.01, 0, 0)), c = mesh.vertex(at + dvec3(0, 0, 0.01));
        mesh.face(a, c, b);
    }
    const MeshPieces pieces = meshPieces(mesh.positions, mesh.triangles, dvec3(0));
    EXPECT_GT(pieces.origins.size(), 8u);
    EXPECT_LE(pieces.origins.size(), 64u);
    ASSERT_EQ(pieces.pieceOf.size(), 900u);
    for (const std::uint32_t piece : pieces.pieceOf)
        ASSERT_LT(piece, pieces.origins.size());
}

TEST(WideMeshes, CrumbsAskForNothing) {
    Written mesh = meshOf(Kind::home);
    const std::uint32_t a = mesh.vertex({5, 0, 0});
    mesh.face(a, mesh.vertex({5, 0, 1e-7}), mesh.vertex({5 + 1e-7, 0, 0}));
    EXPECT_EQ(meshPieces(mesh.positions, mesh.triangles, dvec3(0)).origins.size(), 1u) << "three vertices in 135 are more than crumbs";
    addVillage(mesh, {20, 0, 0}), addVillage(mesh, {20, 0, 20});
    EXPECT_TRUE(meshPieces(mesh.positions, mesh.triangles, dvec3(0)).origins.empty()) << "three in 399";
}

TEST(WideMeshes, PiecesAreOneThing) {
    const TempFolder folder;
    const Snapshot scene = sceneOf(folder, meshOf(Kind::twoVillages), kCountry, R"(, "velocity": [1, 0, 0], "castsShadow": false)");
    ASSERT_EQ(scene->objects.size(), 2u);
    EXPECT_EQ(scene->objects[0].name, scene->objects[1].name);
    EXPECT_FALSE(scene->objects[1].castsShadow);
    for (std::size_t i = 0; i < 2; ++i) {
        const ObjectRange range = piecesOf(*scene, i);
        EXPECT_EQ(range.first, 0u);
        EXPECT_EQ(range.end, 2u);
        const Snapshot moved = withObjectMovedBy(scene, i, {0, 3, 0});
        for (std::size_t k = 0; k < 2; ++k)
            EXPECT_EQ(moved->objects[k].worldFromObject[3], scene->objects[k].worldFromObject[3] + dvec4(0, 3, 0, 0));
    }
    const Snapshot later = atTime(scene, 2);
    for (std::size_t k = 0; k < 2; ++k)
        EXPECT_EQ(later->objects[k].worldFromObject[3].x, scene->objects[k].worldFromObject[3].x + 2);
    EXPECT_EQ(lab::handles(*scene, objectBounds(*scene), scene->camera).size(), 2u) << "the lamp and the mesh";

    const std::string text = sceneText(*scene, scene->camera, folder.path());
    EXPECT_EQ(text.find("m.obj"), text.rfind("m.obj")) << text;
    EXPECT_EQ(loadScene(folder.write("again.json", text).string(), {})->objects.size(), 2u);
}

TEST(WideMeshes, PiecesHaveTheNormalsOfTheWhole) {
    for (const std::string mode : {"smooth", "flat"}) {
        const TempFolder folder;
        const std::string keys = ", \"normals\": \"" + mode + "\"";
        const auto home = sceneOf(folder, meshOf(Kind::home), dvec3(0), keys);
        const auto wide = sceneOf(folder, meshOf(Kind::twoVillages), kCountry, keys);
        ASSERT_EQ(wide->objects.size(), 2u);
        const Mesh &a = *home->objects[0].mesh, &b = *wide->objects[0].mesh;
        ASSERT_EQ(a.triangles.size(), b.triangles.size());
        for (std::size_t t = 0; t < a.triangles.size(); ++t)
            for (int i = 0; i < 3; ++i)
                ASSERT_LT(glm::length(a.normalsMesh[a.triangles[t][i]] - b.normalsMesh[b.triangles[t][i]]), 1e-4f)
                    << mode;
    }
}

TEST(WideMeshes, FarPiecesAreNotPartOfTheViewFromOutside) {
    for (const Kind kind : kKinds) {
        const TempFolder folder;
        const Bounds things = thingsBounds(*sceneOf(folder, meshOf(kind), placeOf(kind)));
        EXPECT_NEAR(glm::length(things.upperWorld - things.lowerWorld), glm::length(dvec3(12, 2.48, 12)), 1e-3) << static_cast<int>(kind);
    }
}

TEST(WideMeshes, OutliersAreNamedAndNotFramed) {
    const TempFolder folder;
    const Snapshot home = loadScene(folder.write("home.obj", meshOf(Kind::home).text.str()).string(), {});
    for (const Kind kind : {Kind::strayApart, Kind::strayOnPost, Kind::strayCorner}) {
        const Written mesh = meshOf(kind);
        const Snapshot scene = loadScene(folder.write("stray.obj", mesh.text.str()).string(), {});
        const std::size_t line = kind == Kind::strayApart ? mesh.lines - 3 : mesh.lines - 1;
        ASSERT_FALSE(scene->notes.empty());
        const std::string named = "stray.obj:" + std::to_string(line) + ": vertex 133 lies 5.4e+06 m";
        EXPECT_TRUE(contains(scene->notes.front(), named)) << scene->notes.front();
        EXPECT_LT(glm::length(scene->camera.positionWorld - home->camera.positionWorld), 1e-3);
        EXPECT_LT(glm::length(scene->light(0).positionWorld - home->light(0).positionWorld), 1e-3);
    }
    for (const Kind kind : {Kind::home, Kind::country, Kind::strayUnused})
        EXPECT_TRUE(loadScene(folder.write("none.obj", meshOf(kind).text.str()).string(), {})->notes.empty()) << static_cast<int>(kind);
}

} // namespace
} // namespace shadowlab::scene
