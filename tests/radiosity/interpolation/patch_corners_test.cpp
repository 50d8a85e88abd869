// Values at the corners of patches: smooth where light is, and nowhere else.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/interpolation/patch_corners.h"

#include <gtest/gtest.h>

#include <map>

#include "techniques/radiosity/patches/contacts.h"
#include "tests/radiosity/interpolation/interpolated.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

/// One quad or more of some size, turned so that no axis lies along it.
scene::Scene turnedQuad(const dvec2& size) {
    scene::Scene scene;
    scene.materials.emplace_back();
    addObject(scene, scene::makeQuad(size), glm::rotate(translation({1, 2, 3}), 0.7, glm::normalize(dvec3(1, 2, 3))));
    return scene;
}

/// Those that are chosen are cut in four, by lines from the middle of each edge to the middle of all.
template <typename Choose>
std::vector<Patch> quartered(const std::vector<Patch>& patches, const Choose& choose) {
    std::vector<Patch> all;
    for (const Patch& patch : patches) {
        const Polygon& q = patch.polygon;
        if (!choose(patch)) {
            all.push_back(patch);
            continue;
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const dvec3 &before = q[(i + 3) % 4], &here = q[i], &after = q[(i + 1) % 4];
            const Polygon part{here, 0.5 * (here + after), patch.centre, 0.5 * (before + here)};
            all.push_back({part, patch.normal, centroid(part), patch.area / 4, patch.face});
        }
    }
    return all;
}

/// Three linear functions at once, all above 0 in these scenes.
dvec3 linear(const dvec3& p) { return {9 + p.x + 2 * p.y - p.z, 9 - 2 * p.x + p.y, 9 + p.z - p.y}; }

std::vector<dvec3> linearOf(const std::vector<Patch>& patches) {
    std::vector<dvec3> values;
    for (const Patch& patch : patches)
        values.push_back(linear(patch.centre));
    return values;
}

double largest(const dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The largest error at a corner, and that of the mean of the patches there, which is what one would take without thinking.
struct LinearErrors {
    double ours = 0, beforeLimits = 0, ofMeans = 0;
    int limited = 0; ///< corners at which the numbers around were gone beyond by too much
};
LinearErrors linearErrors(const Faces& faces, const std::vector<Patch>& patches) {
    const PatchCorners corners = patchCorners(faces, patches);
    const std::vector<dvec3> ofPatches = linearOf(patches), values = corners.values(ofPatches);
    std::vector<dvec3> sums(corners.count(), dvec3(0.0)), truths(corners.count());
    std::vector<double> counts(corners.count(), 0.0);
    for (std::size_t piece = 0; piece < corners.cornerOfPiece.size(); ++piece) {
        const std::uint32_t corner = corners.cornerOfPiece[piece];
        sums[corner] += ofPatches[corners.borders.pieces[piece].patch];
        ++counts[corner];
        truths[corner] = linear(corners.borders.pointsCentred[corners.borders.pieces[piece].point]);
    }
    LinearErrors errors;
    for (std::size_t corner = 0; corner < corners.count(); ++corner) {
        dvec3 sum(0.0);
        for (std::uint32_t i = corners.first[corner]; i < corners.first[corner + 1]; ++i)
            sum += corners.weights[i].weight * ofPatches[corners.weights[i].patch];
        errors.limited += largest(sum - values[corner]) > 0;
        errors.beforeLimits = std::max(errors.beforeLimits, largest(sum - truths[corner]));
        errors.ours = std::max(errors.ours, largest(values[corner] - truths[corner]));
        errors.ofMeans = std::max(errors.ofMeans, largest(sums[corner] / counts[corner] - truths[corner]));
    }
    const std::vector<dvec3> even(patches.size(), dvec3(0.1, 0.7, 1e6 / 3));
    for (const dvec3& value : corners.values(even))
        EXPECT_EQ(value, even[0]) << "what is the same everywhere stays so to the last bit";
    return errors;
}

TEST(PatchCorners, LinearFunctionsAreMet) {
    const Faces faces = facesOf(turnedQuad({3, 2}), trace::worldTriangles(turnedQuad({3, 2})));
    const std::vector<Patch> grid = cutIntoPatches(faces, 0.5);
    ASSERT_EQ(grid.size(), 24u);
    EXPECT_EQ(patchCorners(faces, grid).count(), 7 * 5u);
    // Some ten roundings of numbers about 10.
    const LinearErrors ofGrid = linearErrors(faces, grid);
    EXPECT_LT(ofGrid.ours, 1e-13);
    EXPECT_GT(ofGrid.ofMeans, 0.3) << "means are flat at the rim, by half a patch";

    const std::vector<Patch> finer = quartered(grid, [](const Patch& p) { return p.centre.x > 0; });
    ASSERT_GT(finer.size(), 50u);
    EXPECT_LT(linearErrors(faces, finer).ours, 1e-13);
    EXPECT_LT(linearErrors(faces, cutIntoPatches(faces, 1.6)).ours, 1e-13) << "two by two patches are the fewest";

    // Triangles, and the pieces of what stands on them.
    scene::Scene scene;
    scene.materials.emplace_back();
    addObject(scene, triangleSoup({{0, 0, 0}, {3, 0, 1}, {1, 1, 3}}));
    addObject(scene, scene::makeBox({0.4, 0.4, 0.3}), glm::rotate(translation({1.3, 0.5, 1.3}), 0.4, dvec3(0, 1, 0)));
    const Faces ofTriangle = facesOf(scene, trace::worldTriangles(scene));
    const auto ofFirst = [](std::vector<Patch> all) {
        std::erase_if(all, [](const Patch& p) { return p.face != 0; });
        return all;
    };
    const std::vector<Patch> triangles = ofFirst(cutIntoPatches(ofTriangle, 0.5)),
                             pieces = ofFirst(cutAtContacts(ofTriangle, cutIntoPatches(ofTriangle, 0.3)));
    EXPECT_LT(linearErrors(ofTriangle, triangles).ours, 1e-13);
    ASSERT_GT(pieces.size(), 120u);
    // In the narrow angle between the box and a patch's edge, the rest of that patch and those beside it lie all to one side.
    const LinearErrors ofPieces = linearErrors(ofTriangle, pieces);
    EXPECT_LT(ofPieces.beforeLimits, 1e-10); // slivers are far from each other for their width
    EXPECT_LT(ofPieces.limited, 3);
}

/// Where large patches meet small ones, what is interpolated on both sides of their common edge is the same.
TEST(PatchCorners, TVerticesLeaveNoJump) {
    const scene::Scene scene = turnedQuad({3, 2});
    const Faces faces = facesOf(scene, trace::worldTriangles(scene));
    const std::vector<Patch> patches =
        quartered(cutIntoPatches(faces, 0.5), [](const Patch& p) { return p.centre.x > 0; });
    const PatchCorners corners = patchCorners(faces, patches);
    std::vector<dvec3> values; // bent, so that a straight line between far corners is wrong
    for (const Patch& patch : patches)
        values.emplace_back(1 + 3 * std::exp(-4 * glm::dot(patch.centre, patch.centre)));
    const std::vector<dvec3> atCorners = corners.values(values);
    double jump = 0, naiveJump = 0;
    int compared = 0;
    const PatchBorders& borders = corners.borders;
    for (std::uint32_t piece = 0; piece < borders.pieces.size(); ++piece) {
        const std::uint32_t across = borders.pieces[piece].across;
        if (across == PatchBorders::kNone) continue;
        const std::uint32_t here = borders.pieces[piece].patch, there = borders.pieces[across].patch;
        for (const double along : {0.0, 0.3, 0.5, 0.9, 1.0}) {
            const dvec3 place = glm::mix(borders.pointsCentred[borders.pieces[piece].point],
                                         borders.pointsCentred[borders.pieces[across].point], along);
            const auto jumpAt = [&](bool isAnchored) {
                return largest(interpolated(corners, atCorners, patches, values, here, place, isAnchored) /
                                   interpolated(corners, atCorners, patches, values, there, place, isAnchored) -
                               1.0);
            };
            jump = std::max(jump, jumpAt(true));
            naiveJump = std::max(naiveJump, jumpAt(false));
            ++compared;
        }
    }
    EXPECT_GT(compared, 5 * 150);
    EXPECT_LT(jump, 1e-13);
    EXPECT_GT(naiveJump, 0.01) << "without T-vertices the picture has cracks of more than a hundredth";
}

TEST(PatchCorners, NothingIsNegativeOrFarBeyond) {
    const scene::Scene scene = turnedQuad({3, 2});
    const Faces faces = facesOf(scene, trace::worldTriangles(scene));
    const std::vector<Patch> patches = cutIntoPatches(faces, 0.25);
    const PatchCorners corners = patchCorners(faces, patches);
    std::vector<dvec3> values; // the patches along the rim are darker than all others, or brighter
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const bool isRim = std::ranges::count(corners.borders.of(i), PatchBorders::kNone, &PatchBorders::Piece::across);
        values.emplace_back(isRim ? 1 : 10, isRim ? 10 : 1, 2);
    }
    int below = 0, above = 0;
    for (const dvec3& value : corners.values(values)) {
        EXPECT_GE(value.x, 0);
        EXPECT_LE(value.y, 19);
        EXPECT_EQ(value.z, 2);
        below += value.x == 0;
        above += value.y > 10;
    }
    EXPECT_GT(below, 30) << "nothing was carried on: the case is too easy";
    EXPECT_GT(above, 30);
}

/// How many corners there are in each place of an object.
std::map<std::uint32_t, std::size_t> cornersInPlaces(const PatchCorners& corners) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> found;
    for (std::size_t piece = 0; piece < corners.cornerOfPiece.size(); ++piece)
        found[corners.borders.pieces[piece].point].push_back(corners.cornerOfPiece[piece]);
    std::map<std::uint32_t, std::size_t> counts;
    for (auto& [point, all] : found) {
        std::ranges::sort(all);
        counts[point] = static_cast<std::size_t>(std::ranges::unique(all).begin() - all.begin());
    }
    return counts;
}

TEST(PatchCorners, ABoxHasEdgesAndABallHasNone) {
    scene::Scene box, ball;
    box.materials.emplace_back();
    ball.materials.emplace_back();
    addObject(box, scene::makeBox({1, 1, 1}));
    addObject(ball, scene::makeSphere(1, 8));
    const Faces ofBox = facesOf(box, trace::worldTriangles(box)), ofBall = facesOf(ball, trace::worldTriangles(ball));
    const std::vector<Patch> boxPatches = cutIntoPatches(ofBox, 0.5), ballPatches = cutIntoPatches(ofBall, 0.4);
    std::map<std::size_t, int> places;
    for (const auto& [point, count] : cornersInPlaces(patchCorners(ofBox, boxPatches)))
        ++places[count];
    EXPECT_EQ(places, (std::map<std::size_t, int>{{1, 6}, {2, 12}, {3, 8}}));
    const PatchCorners corners = patchCorners(ofBall, ballPatches);
    int compared = 0;
    for (const auto& [point, count] : cornersInPlaces(corners)) {
        EXPECT_EQ(count, 1u);
        ++compared;
    }
    EXPECT_GT(compared, 50);
    // Trapezoids and triangles of different sizes share whole edges with T-vertices on them: nowhere is a rim.
    for (const PatchBorders::Piece& piece : corners.borders.pieces)
        EXPECT_NE(piece.across, PatchBorders::kNone);
}

TEST(PatchCorners, OtherMaterialsAndOtherSidesAreApart) {
    scene::Scene scene = turnedQuad({2, 2});
    Faces faces = facesOf(scene, trace::worldTriangles(scene));
    // The same sheet seen from behind.
    Face back = faces.all[0];
    back.polygon = {back.polygon[3], back.polygon[2], back.polygon[1], back.polygon[0]};
    back.plane.normal = -back.plane.normal;
    faces.all.push_back(back);
    const std::vector<Patch> patches = cutIntoPatches(faces, 0.5);
    ASSERT_EQ(patches.size(), 32u);
    const PatchCorners corners = patchCorners(faces, patches);
    EXPECT_EQ(corners.count(), 2 * 25u);
    for (const auto& [point, count] : cornersInPlaces(corners))
        EXPECT_EQ(count, 2u);
    std::vector<dvec3> values(32, dvec3(0.0));
    std::fill(values.begin(), values.begin() + 16, dvec3(1));
    std::map<double, int> found;
    for (const dvec3& value : corners.values(values))
        ++found[value.x];
    EXPECT_EQ(found, (std::map<double, int>{{0.0, 25}, {1.0, 25}}));

    // Two triangles of a folded sheet, at 20 degrees; once of one material, once of two.
    scene::Scene folded;
    folded.materials.resize(2);
    addObject(folded, triangleSoup({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, 0}, {-1, -0.36, 0}, {0, 0, 1}}));
    Faces ofFolded = facesOf(folded, trace::worldTriangles(folded));
    ASSERT_EQ(ofFolded.all.size(), 2u);
    const std::vector<Patch> whole = cutIntoPatches(ofFolded, 5);
    EXPECT_EQ(patchCorners(ofFolded, whole).count(), 4u);
    ofFolded.all[1].material = 1;
    EXPECT_EQ(patchCorners(ofFolded, whole).count(), 6u);
}

/// What touches what does not depend on how large a scene is, or where.
TEST(PatchCorners, ScaledAndMovedScenesHaveTheSame) {
    const auto counts = [](const scene::Scene& scene) {
        const Faces faces = facesOf(scene, trace::worldTriangles(scene));
        const std::vector<Patch> patches =
            cutAtContacts(faces, cutIntoPatches(faces, 0.1 * sizeOf(faces.all[0].polygon)));
        const PatchCorners corners = patchCorners(faces, patches);
        const auto open = std::ranges::count(corners.borders.pieces, PatchBorders::kNone, &PatchBorders::Piece::across);
        return std::array{patches.size(), corners.count(), corners.borders.pieces.size(),
                          static_cast<std::size_t>(open), corners.borders.parted.size()};
    };
    const scene::Scene scene = simpleScene();
    const auto expected = counts(scene);
    EXPECT_GT(expected[0], 1000u);
    EXPECT_GT(expected[4], 5u) << "nothing stands on anything: the case is too easy";
    for (const double factor : {1.0 / 1024, 1024.0}) // of which no vertex is rounded
        EXPECT_EQ(counts(scaled(scene, factor)), expected) << factor;
    EXPECT_EQ(counts(moved(scene, {1048576, 0, -1048576})), expected);
}

} // namespace
} // namespace shadowlab::radiosity
