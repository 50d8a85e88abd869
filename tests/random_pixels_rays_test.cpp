// The vectors of the ray tree for pixels taken by chance over all built-in scenes: N from the mesh's normals, R by the law of
// reflection, T by Snell's law, L toward the light, all computed here; and the form factor of two patches by pairs of points taken by
// chance on both.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <iostream>

#include <glm/gtc/constants.hpp>

#include "techniques/probed/patch_exchange.h"
#include "tests/support/random_pixels.h"

namespace shadowlab {
namespace {

using testing::AskedPixel;
using testing::Deviation;
using testing::WorldTriangle;

std::optional<dvec3> vectorNamed(const Probe& probe, std::string_view label) {
    for (const Probe::Vector& one : probe.vectors)
        if (one.label == label) return one.directionWorld;
    return std::nullopt;
}

/// The mesh's normals at the corners, interpolated, as they lie in the world, on the eye's side; none where that is not the side of
/// the triangle's own normal, which each program fixes in its own way.
std::optional<dvec3> shadingNormal(const AskedPixel& asked) {
    const WorldTriangle& seen = asked.triangles[asked.seen];
    const scene::Object& object = asked.scene.objects[seen.object];
    const auto& c = seen.cornersWorld;
    const dvec3 whole = glm::cross(c[1] - c[0], c[2] - c[0]);
    const double area = glm::dot(whole, whole);
    const dvec3 p = asked.pointWorld;
    const dvec3 weights(glm::dot(glm::cross(c[1] - p, c[2] - p), whole) / area,
                        glm::dot(glm::cross(c[2] - p, c[0] - p), whole) / area,
                        glm::dot(glm::cross(c[0] - p, c[1] - p), whole) / area);
    const dmat3 normalFromMesh = glm::transpose(glm::inverse(dmat3(object.worldFromObject)));
    dvec3 normal(0.0);
    for (int i = 0; i < 3; ++i)
        normal +=
            weights[i] *
            glm::normalize(normalFromMesh * dvec3(object.mesh->normalsMesh[object.mesh->triangles[seen.triangle][i]]));
    normal = glm::normalize(normal);
    const double eyeSide = -glm::dot(normal, asked.eyeWay);
    if (std::abs(eyeSide) < 0.05) return std::nullopt; // seen nearly from its edge
    return eyeSide > 0 ? normal : -normal;
}

/// R and T of one ray's end, from its own u and N.
void addLaws(const AskedPixel& asked, const Probe::Node& node, Deviation& reflected, Deviation& refracted) {
    const auto fact = [&](std::string_view label) -> const Probe::Fact* {
        const auto found = std::ranges::find(node.facts, label, &Probe::Fact::label);
        return found == node.facts.end() ? nullptr : &*found;
    };
    const auto vector = [&](std::string_view label) {
        const std::vector<double>& numbers = fact(label)->numbers;
        return dvec3(numbers[0], numbers[1], numbers[2]);
    };
    for (const scene::Object& object : asked.scene.objects) {
        const scene::Material& material = asked.scene.materials[object.partMaterials.front()];
        const bool isSpread = material.glossDegrees > 0 || material.translucencyDegrees > 0;
        if (object.name == node.object && isSpread) return; // sent about these directions, by chance
    }
    if (!fact("u") || !fact("N")) return;
    const dvec3 u = vector("u"), n = vector("N");
    const double cosine = -glm::dot(u, n);
    if (fact("R")) reflected.add(glm::length(vector("R") - (u + 2 * cosine * n)));
    if (!fact("T")) return;
    const double ratio = fact("index of refraction")->numbers[0] / fact("index of refraction")->numbers[1];
    const dvec3 byLaw = ratio * u + (ratio * cosine - std::sqrt(1 - ratio * ratio * (1 - cosine * cosine))) * n;
    refracted.add(glm::length(vector("T") - byLaw));
}

TEST(RandomPixelsRaysTest, VectorsOfTheTreeFollowTheirLaws) {
    Deviation u, normal, reflected, refracted, light;
    int grazing = 0;
    testing::forRandomPixels(
        {.technique = "ray-traced", .values = {}, .pixels = 40, .seed = 61}, [&](const AskedPixel& asked) {
            const auto toldU = vectorNamed(asked.probe, "u"), toldV = vectorNamed(asked.probe, "V"),
                       toldN = vectorNamed(asked.probe, "N");
            ASSERT_TRUE(toldU && toldV && toldN) << asked.where();
            u.add(glm::length(*toldU - asked.eyeWay));
            u.add(glm::length(*toldV + asked.eyeWay));
            const auto expected = shadingNormal(asked);
            if (!expected) {
                ++grazing;
                return;
            }
            normal.add(glm::length(*toldN - *expected));
            for (const Probe::Node& node : asked.probe.tree)
                addLaws(asked, node, reflected, refracted);
            if (const auto l = vectorNamed(asked.probe, "L"))
                light.add(glm::length(*l - glm::normalize(asked.towardLight())));
        });
    std::cout << "u, V: " << u.compared << ", off by " << u.largest << "; N: " << normal.compared << ", "
              << normal.largest << "; R: " << reflected.compared << ", " << reflected.largest
              << "; T: " << refracted.compared << ", " << refracted.largest << "; L: " << light.compared << ", "
              << light.largest << "; " << grazing << " seen from the edge\n";
    EXPECT_GT(normal.compared, 120);
    EXPECT_GT(reflected.compared, 10);
    EXPECT_GT(refracted.compared, 10);
    EXPECT_GT(light.compared, 120);
    EXPECT_LT(u.largest, 1e-9);
    EXPECT_LT(light.largest, 1e-9);
    // A mesh's normals are floats, and unit only to 2^-24.
    EXPECT_LT(normal.largest, 1e-6);
    EXPECT_LT(reflected.largest, 2e-6);
    EXPECT_LT(refracted.largest, 4e-6);
}

/// A point of a patch by chance: of a triangle or a rectangle of a fan, each as often as it is large.
dvec3 pointOf(const PatchProbe& patch, std::mt19937& random) {
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<double> areas;
    for (std::size_t i = 1; i + 1 < patch.cornersWorld.size(); ++i)
        areas.push_back(glm::length(glm::cross(patch.cornersWorld[i] - patch.cornersWorld[0],
                                               patch.cornersWorld[i + 1] - patch.cornersWorld[0])));
    const auto i = static_cast<std::size_t>(std::discrete_distribution<int>(areas.begin(), areas.end())(random)) + 1;
    double a = share(random), b = share(random);
    if (a + b > 1) {
        a = 1 - a;
        b = 1 - b;
    }
    return patch.cornersWorld[0] + a * (patch.cornersWorld[i] - patch.cornersWorld[0]) +
           b * (patch.cornersWorld[i + 1] - patch.cornersWorld[0]);
}

// F_jk dA_j = the mean over pairs of points of cos cos V / (pi r^2), times dA_j dA_k. Where nothing stands in between the program
// integrates to 1e-7, and all that is left is the deviation of the 20,000 pairs here: four of these. Where something does, it tries
// eight lines at least (kFewestLines of visible_exchange.cpp): they err by 0.5 / sqrt(8) = 0.18 of the whole at most, as a standard
// deviation.
TEST(RandomPixelsRaysTest, FormFactorsAreThoseOfPairsOfPoints) {
    const auto root = context::assetsRoot();
    const scene::Snapshot scene = scene::loadScene("cornell-room", {.assetsRoot = root, .allowed = {}, .limits = {}});
    const std::vector<WorldTriangle> triangles = testing::allTriangles(*scene);
    picture::Slot slot = picture::Session::makeSlot("radiosity");
    View view;
    view.camera = scene->camera;
    view.size = testing::kPictureSize;
    std::mt19937 random(71);
    int compared = 0;
    Deviation free, inPart, reciprocity;
    for (int i = 0; i < 24; ++i) {
        const auto pixel = [&] {
            return ivec2(60 + static_cast<int>(random() % 200), 20 + static_cast<int>(random() % 140));
        };
        view.picked = pixel();
        view.partner = pixel();
        const Probe probe = slot.technique->probe(scene, view, *view.picked, 0);
        if (!probe.find<PatchExchange>() || !probe.find<PatchExchange>()->k || probe.find<PatchExchange>()->formFactorJk <= 0) continue;
        const PatchProbe &j = probe.find<PatchExchange>()->j, &k = *probe.find<PatchExchange>()->k;
        reciprocity.add(probe.find<PatchExchange>()->formFactorJk * j.area / (probe.find<PatchExchange>()->formFactorKj * k.area) - 1);
        double sum = 0, squares = 0, whole = 0;
        int facing = 0, hidden = 0;
        constexpr int kPairs = 20'000;
        for (int n = 0; n < kPairs; ++n) {
            const dvec3 from = pointOf(j, random), to = pointOf(k, random), r = to - from;
            const double cosJ = glm::dot(j.normalWorld, r), cosK = -glm::dot(k.normalWorld, r), far = glm::dot(r, r);
            if (cosJ <= 0 || cosK <= 0) continue;
            bool isFree = true;
            for (const WorldTriangle& one : triangles) {
                const auto hit = meets(one, from, r);
                isFree = isFree && !(hit && hit->inside > 0 && hit->along > 1e-6 && hit->along < 1 - 1e-6);
                if (!isFree) break;
            }
            ++facing;
            whole += cosJ * cosK / (glm::pi<double>() * far * far) / kPairs;
            hidden += !isFree;
            const double value = isFree ? cosJ * cosK / (glm::pi<double>() * far * far) : 0;
            sum += value;
            squares += value * value;
        }
        const double mean = sum / kPairs, deviation = std::sqrt((squares / kPairs - mean * mean) / kPairs);
        ++compared;
        const double told = probe.find<PatchExchange>()->formFactorJk, expected = mean * k.area;
        (hidden > 0 ? inPart : free).add((told - expected) / told);
        EXPECT_NEAR(told, expected, 4 * deviation * k.area + (hidden > 0 ? 0.18 * whole * k.area : 1e-7))
            << hidden << " of " << facing << " hidden; " << view.picked->x << "," << view.picked->y << " and "
            << view.partner->x << "," << view.partner->y;
    }
    std::cout << compared << " form factors; " << free.compared << " with nothing in between, off by a share of "
              << free.largest << " at most, " << inPart.compared << " hidden in part, " << inPart.largest
              << "; reciprocity " << reciprocity.largest << "\n";
    EXPECT_GT(compared, 5);
    EXPECT_LT(reciprocity.largest, 1e-5);
}

} // namespace
} // namespace shadowlab
