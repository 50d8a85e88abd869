// What every technique says of a pixel, for pixels taken by chance over all built-in scenes, against plain loops over triangles in
// double: the surface, what is true, what shadow volumes count, where planes are, and which face was found to block the light.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "techniques/probed/plane_probe.h"
#include "techniques/probed/volume_probe.h"
#include "techniques/registry.h"
#include "tests/support/random_pixels.h"

namespace shadowlab {
namespace {

using testing::AskedPixel;
using testing::Deviation;
using testing::WorldTriangle;

// Lengths in these scenes are some metres, and double has 16 digits: what is left after a dozen products.
constexpr double kMetres = 1e-9;

/// Triangles between a place and the light of which `wanted` says yes; -1 where an edge is too near to say.
template <typename Wanted>
int between(const AskedPixel& asked, const dvec3& placeWorld, std::size_t except, const Wanted& wanted) {
    const dvec4 light = asked.lightWorld();
    const dvec3 way = dvec3(light) - placeWorld * light.w;
    constexpr double kContact = 1e-9; // nearer is contact: neighbours of the point's own triangle
    int count = 0;
    for (std::size_t i = 0; i < asked.triangles.size(); ++i) {
        const WorldTriangle& one = asked.triangles[i];
        if (i == except || !asked.scene.objects[one.object].castsShadow || !wanted(one)) continue;
        const auto hit = meets(one, placeWorld, way);
        if (!hit || hit->along < -kContact || (light.w == 1 && hit->along > 1 + kContact)) continue;
        if (std::abs(hit->inside) < 1e-9) return -1;
        if (hit->inside < 0) continue;
        if (hit->along < kContact) continue;
        if (light.w == 1 && hit->along > 1 - kContact) return -1;
        ++count;
    }
    return count;
}

bool facesLight(const AskedPixel& asked, const WorldTriangle& one) {
    const dvec4 light = asked.lightWorld();
    const dvec3 toLight = dvec3(light) - one.cornersWorld[0] * light.w;
    const bool mirrored = glm::determinant(dmat3(asked.scene.objects[one.object].worldFromObject)) < 0;
    return (glm::dot(one.normal(), toLight) > 0) != mirrored;
}

/// Is each edge of the object's surface shared by exactly two triangles that run along it in opposite directions?
bool isClosed(const scene::Object& object) {
    using Place = std::array<float, 3>;
    std::map<std::pair<Place, Place>, int> runs;
    const auto place = [&](std::uint32_t vertex) {
        const vec3& p = object.mesh->positionsMesh[vertex];
        return Place{p.x, p.y, p.z};
    };
    for (const uvec3& t : object.mesh->triangles)
        for (int i = 0; i < 3; ++i) {
            const Place a = place(t[i]), b = place(t[(i + 1) % 3]);
            if (a < b)
                runs[{a, b}] += 1;
            else
                runs[{b, a}] += 1000;
        }
    return std::ranges::all_of(runs, [](const auto& run) { return run.second == 1001; });
}

TEST(RandomPixelsTest, EveryTechniqueNamesTheSurfaceAndWhatIsTrueOfIt) {
    int compared = 0, lit = 0, shadowed = 0, turned = 0, doubtful = 0, leftOut = 0;
    Deviation distance;
    for (const RegisteredTechnique& technique : techniquesOf(TechniqueGroup::production)) {
        if (technique.info->id == "radiosity") continue; // solves a room for each scene; see below
        leftOut += testing::forRandomPixels(
            {.technique = std::string(technique.info->id), .values = {}, .pixels = 12, .seed = 17},
            [&](const AskedPixel& asked) {
                const WorldTriangle& seen = asked.triangles[asked.seen];
                const scene::Light& source = asked.scene.light(asked.light);
                ASSERT_TRUE(testing::factNamed(asked.probe, "triangle")) << asked.where();
                EXPECT_EQ(testing::factNamed(asked.probe, "surface")->value, asked.scene.objects[seen.object].name);
                EXPECT_EQ(testing::factNamed(asked.probe, "triangle")->numbers[0], seen.triangle) << asked.where();
                distance.add(testing::factNamed(asked.probe, "distance from the eye")->numbers[0] -
                             glm::length(asked.pointWorld - asked.scene.camera.positionWorld));
                ++compared;
                if (testing::hasHoles(asked.scene)) return;
                // The gates, in their order: facing, cone, the rect's side; then what receives no shadow.
                const dvec3 toLight = asked.towardLight();
                const double facing = glm::dot(asked.normal(), glm::normalize(toLight));
                double margin = std::abs(facing);
                bool shines = facing > 0;
                if (source.type == scene::LightType::spot) {
                    const double cosine = glm::dot(-glm::normalize(toLight), source.directionWorld),
                                 least = std::cos(glm::radians(source.coneDegrees / 2));
                    margin = std::min(margin, std::abs(cosine - least));
                    shines = shines && cosine > least;
                }
                if (source.type == scene::LightType::rect) {
                    const double side = glm::dot(glm::normalize(glm::cross(source.edgeUWorld, source.edgeVWorld)),
                                                 -glm::normalize(toLight));
                    margin = std::min(margin, std::abs(side));
                    shines = shines && side > 0;
                }
                const int blockers = between(asked, asked.pointWorld, asked.seen, [](const auto&) { return true; });
                if (blockers < 0 || margin < 1e-6) { // floats of the scene file have no more
                    ++doubtful;
                    return;
                }
                const bool free = blockers == 0 || !asked.scene.objects[seen.object].receivesShadow;
                const std::string expected = !shines ? "turned away" : free ? "lit" : "in shadow";
                const Probe::Fact* truth = testing::factNamed(asked.probe, "truth");
                ASSERT_TRUE(truth) << asked.where();
                EXPECT_EQ(truth->value, expected) << technique.info->id << " " << asked.where();
                lit += expected == "lit";
                shadowed += expected == "in shadow";
                turned += expected == "turned away";
            });
    }
    std::cout << compared << " surfaces, distance off by " << distance.largest << " m at most; truth: " << lit
              << " lit, " << shadowed << " in shadow, " << turned << " turned away, " << doubtful
              << " too near to an edge; " << leftOut << " left out at edges that the eye sees\n";
    EXPECT_GT(compared, 300);
    EXPECT_LT(distance.largest, kMetres * 10);
    EXPECT_GT(lit, 100);
    EXPECT_GT(shadowed, 70);
    EXPECT_LT(doubtful, compared / 10);
}

// n_f and n_b: of a closed body the faces toward the light that stand between a place and the light say in how many volumes it is;
// of an open one all faces. z-pass is off by what the eye is in.
TEST(RandomPixelsTest, ShadowVolumesCountWhatStandsBetween) {
    int compared = 0, inside = 0, doubtful = 0, eyeInside = 0;
    for (const char* technique : {"shadow-volume-zpass", "shadow-volume-zfail", "shadow-volume"}) {
        std::map<std::string, std::vector<bool>> closed; // per scene, of each object
        testing::forRandomPixels(
            {.technique = technique, .values = {{"cull", "false"}}, .pixels = 25, .seed = 23},
            [&](const AskedPixel& asked) {
                if (!asked.probe.find<VolumeProbe>()) return;
                std::vector<bool>& of = closed[asked.name];
                if (of.empty())
                    for (const scene::Object& object : asked.scene.objects)
                        of.push_back(isClosed(object));
                const auto volumesAt = [&](const dvec3& placeWorld, std::size_t except) {
                    return between(asked, placeWorld, except,
                                   [&](const WorldTriangle& one) { return !of[one.object] || facesLight(asked, one); });
                };
                const int point = volumesAt(asked.pointWorld, asked.seen),
                          eye = volumesAt(asked.scene.camera.positionWorld, asked.triangles.size());
                // Turned away, the point's own face stands between it and the light by nothing at all.
                const bool turned = glm::dot(asked.normal(), asked.towardLight()) <= 0;
                if (point < 0 || eye < 0 || turned) {
                    ++doubtful;
                    return;
                }
                const VolumeProbe& volume = *asked.probe.find<VolumeProbe>();
                EXPECT_EQ(volume.frontsBefore - volume.backsBefore, point - eye) << technique << " " << asked.where();
                EXPECT_EQ(volume.backsBeyond - volume.frontsBeyond, point) << technique << " " << asked.where();
                EXPECT_EQ(volume.eyeCount, eye) << technique << " " << asked.where();
                ++compared;
                inside += point > 0;
                eyeInside += eye > 0;
            },
            false);
    }
    std::cout << compared << " counts, " << inside << " points in volumes, " << eyeInside << " with the eye in one; "
              << doubtful << " turned away or too near to an edge\n";
    EXPECT_GT(compared, 150);
    EXPECT_GT(inside, 40);
    EXPECT_GT(eyeInside, 3);
}

TEST(RandomPixelsTest, PlanesHeightsAndWeightsAreThoseOfTheTriangles) {
    Deviation plane, height, weight;
    int compared = 0, covers = 0, casting = 0, doubtful = 0, without = 0;
    testing::forRandomPixels(
        {.technique = "planar", .values = {{"cull", "false"}}, .pixels = 30, .seed = 31},
        [&](const AskedPixel& asked) {
            if (!asked.probe.find<PlaneProbe>()) return;
            const PlaneProbe& told = *asked.probe.find<PlaneProbe>();
            if (!told.receives) {
                ++without;
                EXPECT_EQ(told.covers.size(), 0u);
                return;
            }
            ++compared;
            const WorldTriangle& seen = asked.triangles[asked.seen];
            for (const dvec3& corner : seen.cornersWorld)
                plane.add(glm::dot(told.planeWorld, dvec4(corner, 1)));
            plane.add(std::abs(glm::dot(dvec3(told.planeWorld), asked.normal())) - 1);
            plane.add(glm::length(dvec3(told.planeWorld)) - 1);
            const dvec3 toLight = asked.towardLight();
            const double lightHeight = std::abs(glm::dot(asked.normal(), toLight));
            int expected = 0;
            bool isDoubtful = false;
            for (const WorldTriangle& one : asked.triangles) {
                if (!asked.scene.objects[one.object].castsShadow) continue;
                const auto hit = meets(one, asked.pointWorld, toLight);
                if (!hit) continue;
                // The height of a place on the line: the plane is at 0, the light at 1 (or nowhere).
                const bool isBefore = asked.lightWorld().w == 0 || hit->along < 1;
                const double metres = hit->along * lightHeight;
                if (std::abs(metres) < 1e-9) continue; // the plane itself
                if (std::abs(hit->inside) < 1e-6 || std::abs(std::abs(metres) - told.contact) < 1e-6)
                    isDoubtful = isDoubtful || metres > -1e-6;
                expected += hit->inside > 0 && isBefore && metres > told.contact + 1e-6;
            }
            int counted = 0;
            for (const PlaneProbe::Cover& cover : told.covers) {
                ++covers;
                counted += cover.casts;
                const double along =
                    glm::dot(cover.placeWorld - asked.pointWorld, toLight) / glm::dot(toLight, toLight);
                height.add(cover.height - along * lightHeight);
                weight.add(cover.weight - lightHeight * (asked.lightWorld().w == 0 ? 1 : 1 - along));
            }
            if (isDoubtful) {
                ++doubtful;
                return;
            }
            EXPECT_EQ(counted, expected) << asked.where();
            casting += expected > 0;
        },
        false);
    std::cout << compared << " points on planes, " << without << " on none, " << covers << " triangles on lines, "
              << casting << " points in shadow, " << doubtful << " doubtful; off at most: planes " << plane.largest
              << ", heights " << height.largest << " m, weights " << weight.largest << "\n";
    EXPECT_GT(compared, 100);
    EXPECT_GT(covers, 100);
    EXPECT_GT(casting, 20);
    EXPECT_LT(doubtful, compared / 3);
    // A plane is fitted to all corners of its face, which are floats: 2^-24 of some metres.
    EXPECT_LT(plane.largest, 2e-6);
    EXPECT_LT(height.largest, 1e-5);
    EXPECT_LT(weight.largest, 1e-5);
}

// The exact map and the alias-free one name the face that they found. It stands between the point and the light, and is not the
// point's own.
TEST(RandomPixelsTest, TheFaceThatBlocksStandsInTheWay) {
    for (const std::string technique : {"shadow-map-exact", "shadow-map-alias-free"}) {
        testing::AskedSettings settings{.technique = technique, .values = {}, .pixels = 20, .seed = 41};
        if (technique == "shadow-map-exact") settings.values = {{"resolution", "256"}};
        int decided = 0, named = 0;
        testing::forRandomPixels(
            settings,
            [&](const AskedPixel& asked) {
                ASSERT_TRUE(asked.probe.decision) << asked.where();
                ++decided;
                EXPECT_EQ(asked.probe.decision->why, "") << technique << " " << asked.where();
                const bool isLit = testing::factNamed(asked.probe, "truth")->value == "lit";
                EXPECT_EQ(asked.probe.decision->visibility, isLit ? 1 : 0) << technique << " " << asked.where();
                if (!asked.probe.decision->blocker) return;
                ++named;
                const Decision::Face& face = *asked.probe.decision->blocker;
                bool stands = false;
                for (std::size_t i = 0; i < asked.triangles.size(); ++i) {
                    const WorldTriangle& one = asked.triangles[i];
                    if (i == asked.seen || one.triangle != face.triangle ||
                        asked.scene.objects[one.object].name != face.object)
                        continue;
                    const auto hit = meets(one, asked.pointWorld, asked.towardLight());
                    stands = stands || (hit && hit->inside > -1e-9 && hit->along > -1e-9 &&
                                        (asked.lightWorld().w == 0 || hit->along < 1 + 1e-9));
                }
                EXPECT_TRUE(stands) << technique << " " << asked.where() << ": " << face.object << " " << face.triangle;
            },
            false);
        std::cout << technique << ": " << decided << " decisions, " << named << " faces named\n";
        EXPECT_GT(decided, 60);
        EXPECT_GT(named, 20);
    }
}

} // namespace
} // namespace shadowlab
