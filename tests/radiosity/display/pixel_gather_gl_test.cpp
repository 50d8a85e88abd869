// Final gather, held against a furnace, a closed form, and paths followed by chance.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "app/context/assets.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/radiosity/form_factors/point_form_factor.h"
#include "tests/radiosity/scene_room.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/light_shares.h"

namespace shadowlab {
namespace {

using RadiosityGatherTest = testing::GlTest;

/// What the pixel shows of a floor at the height 0, world space.
dvec3 floorPoint(const scene::Camera& camera, ivec2 pixel, ivec2 size) {
    const dvec3 direction = scene::rayDirectionWorld(camera, dvec2(pixel) + 0.5, size);
    return camera.positionWorld - camera.positionWorld.y / direction.y * direction;
}

/// Of a picture that shows nothing but that floor: by what share its pixels are off what is expected at their points, in the mean and at most.
struct FloorErrors {
    double mean = 0, worst = 0;
};
FloorErrors errorsOnFloor(const std::vector<vec4>& texels, const scene::Camera& camera, ivec2 size, const auto& expectedAt) {
    FloorErrors errors;
    EXPECT_EQ(texels.size(), static_cast<std::size_t>(size.x * size.y));
    for (int i = 0; i < size.x * size.y; ++i) {
        const double expected = expectedAt(floorPoint(camera, {i % size.x, i / size.x}, size));
        EXPECT_GT(expected, 0);
        const double error = std::abs(static_cast<double>(texels[static_cast<std::size_t>(i)].g) / expected - 1);
        errors.mean += error / (size.x * size.y);
        errors.worst = std::max(errors.worst, error);
    }
    return errors;
}

// Whatever direction a ray takes, it finds the same radiosity.
TEST_F(RadiosityGatherTest, InAFurnaceEveryRayIsRight) {
    scene::Scene scene = testing::emptyRoom({3, 2, 4});
    scene.materials[0].emission = vec3(0.25f);
    scene.materials[0].diffuse = vec3(0.5f);
    scene.camera.positionWorld = {0.3, 1.2, 3.6};
    scene.camera.targetWorld = {2, 0.7, 0};
    scene.camera.fovYDegrees = 80;
    testing::TechniqueSlot radiosity("radiosity", testing::snapshot(scene));
    for (const std::string gather : {"gather=pixels", "gather=shared"}) {
        const std::vector<vec4> texels = radiosity.radiance({"patches=150", "tolerance=1e-6", gather, "gather-samples=3"}, {64, 48});
        ASSERT_EQ(texels.size(), 64u * 48u);
        for (const vec4& texel : texels)
            ASSERT_NEAR(texel.g, 0.5, 0.5 / 512) << gather; // half floats have 11 bits, and two are added
    }
}

// Each stop doubles all there is in the picture: what is emitted, direct and gathered.
TEST_F(RadiosityGatherTest, ExposureIsOfAllLight) {
    const scene::Snapshot scene = scene::loadScene("cornell-room", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    testing::TechniqueSlot radiosity("radiosity", scene);
    for (const std::string gather : {"gather=none", "gather=shared", "gather=pixels"}) {
        const std::vector<std::string> few{"patches=100", "gather-samples=4", gather};
        const std::vector<vec4> once = radiosity.radiance(few, {64, 36});
        std::vector<std::string> brighter = few;
        brighter.emplace_back("exposure=1");
        const std::vector<vec4> twice = radiosity.radiance(brighter, {64, 36});
        int compared = 0;
        for (std::size_t i = 0; i < once.size(); ++i) {
            if (glm::all(glm::lessThan(glm::abs(vec3(once[i]) - scene->background), vec3(1e-4f)))) continue; // the background stays
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(twice[i][c], 2 * once[i][c], 0.002f * twice[i][c] + 1e-5f) << gather; // half floats, two added
            ++compared;
        }
        EXPECT_GT(compared, 1000);
    }
}

// A floor below a wall that shines, wide and high: at the distance d from its foot the floor sees it at a form factor of
// (1 - d / sqrt(d^2 + h^2)) / 2. One patch for all of the floor knows nothing of d; each pixel finds it.
TEST_F(RadiosityGatherTest, BeforeAWallTheFloorIsItsClosedForm) {
    constexpr double kHeight = 2, kWide = 2000;
    scene::Scene scene;
    scene.materials.resize(2);
    scene.materials[0].diffuse = vec3(0.8f);
    scene.materials[1].diffuse = vec3(0.0f);
    scene.materials[1].emission = vec3(1.0f);
    testing::addObject(scene, scene::makeQuad({8, 8}), testing::translation({0, 0, 4}));
    testing::addObject(scene, scene::makeQuad({kWide, kHeight}),
                       glm::rotate(testing::translation({0, kHeight / 2, 0}), glm::radians(90.0), dvec3(1, 0, 0)));
    scene.objects[1].partMaterials = {1};
    scene.camera.positionWorld = {0, 5, 4.001};
    scene.camera.targetWorld = {0, 0, 4};
    scene.camera.fovYDegrees = 40;
    const ivec2 size{24, 24};
    const auto meanError = [&](const std::string& gather) {
        testing::TechniqueSlot radiosity("radiosity", testing::snapshot(scene));
        const std::vector<vec4> texels =
            radiosity.radiance({"patches=6", "surroundings=dark", gather, "gather-samples=4096"}, size);
        return errorsOnFloor(texels, scene.camera, size, [&](const dvec3& point) {
                   const double factor = (1 - point.z / std::hypot(point.z, kHeight)) / 2;
                   return static_cast<double>(scene.materials[0].diffuse.x) * factor; // rho / pi * pi L F
               })
            .mean;
    };
    EXPECT_LT(meanError("gather=shared"), 0.02);
    EXPECT_LT(meanError("gather=pixels"), 0.02) << "of 4096 rays chosen by chance it would be 0.05: on average a twentieth of them meets the wall";
    EXPECT_GT(meanError("gather=none"), 0.2) << "one number for all of the floor";
}

// On a plain in the open no ray meets anything: what one pixel finds holds for all of them. Of 144 rows every second one gathers.
TEST_F(RadiosityGatherTest, PixelsThatSeeNothingNearShare) {
    scene::Scene scene;
    scene.background = vec3(0.2f);
    scene.materials.resize(1);
    testing::addObject(scene, scene::makeQuad({100, 100}), dmat4(1));
    scene.camera.positionWorld = {0, 3, 4};
    scene.camera.targetWorld = {0, 0, 0};
    const ivec2 size{256, 144};
    testing::TechniqueSlot radiosity("radiosity", testing::snapshot(scene));
    // Beyond the last row and column of the lattice a plane only goes on: there every other pixel gathers by itself, but for the last two.
    EXPECT_EQ(radiosity.counted({"gather=shared"}, size, "gathering"), size.x * size.y / 4 + (size.x + size.y) / 2 - 1);
    for (const vec4& texel : radiosity.radiance({"gather=shared"}, size))
        ASSERT_NEAR(texel.g, 0.2f * scene.materials[0].diffuse.g, 1e-3f);
}

// A small bright quad above a floor, which one ray of a few thousand meets: rays to points of it find its light without noise. From a
// point straight below a corner of a parallel rectangle of the sides a and b at the height h, the form factor is a closed form
// (J. R. Howell, "A Catalog of Radiation Configuration Factors", B-3); other points are sums and differences of such.
TEST_F(RadiosityGatherTest, ASmallEmitterIsItsClosedFormAlongFewRays) {
    constexpr double kSide = 0.1, kHeight = 1.5;
    scene::Scene scene;
    scene.materials.resize(2);
    scene.materials[0].diffuse = vec3(0.6f);
    scene.materials[1].diffuse = vec3(0.0f);
    scene.materials[1].emission = vec3(20.0f);
    testing::addObject(scene, scene::makeQuad({4, 4}), dmat4(1));
    testing::addObject(scene, scene::makeQuad({kSide, kSide}),
                       glm::rotate(testing::translation({0, kHeight, 0}), glm::pi<double>(), dvec3(1, 0, 0)));
    scene.objects[1].partMaterials = {1};
    scene.camera.positionWorld = {0, 1.4, 0.001};
    scene.camera.targetWorld = {0, 0, 0};
    scene.camera.fovYDegrees = 70;
    const ivec2 size{32, 32};
    const auto ofCorner = [](double a, double b) {
        const double x = std::hypot(a, kHeight), y = std::hypot(b, kHeight);
        return (a / x * std::atan(b / x) + b / y * std::atan(a / y)) / glm::two_pi<double>();
    };
    for (const auto& [gather, mostMean, most] : {std::tuple(std::string("gather=pixels"), 0.005, 0.05), {"gather=shared", 0.02, 0.1}}) {
        testing::TechniqueSlot radiosity("radiosity", testing::snapshot(scene));
        const std::vector<vec4> texels = radiosity.radiance({"patches=8", "surroundings=dark", gather, "gather-samples=32"}, size);
        const FloorErrors errors = errorsOnFloor(texels, scene.camera, size, [&](const dvec3& p) {
            double factor = 0;
            for (const double i : {-1.0, 1.0})
                for (const double j : {-1.0, 1.0})
                    factor += i * j * ofCorner(i * kSide / 2 - p.x, j * kSide / 2 - p.z);
            return 0.6 * 20 * factor; // rho / pi * pi L F
        });
        EXPECT_LT(errors.mean, mostMean) << gather << ": without such rays it is above 1, nearly all pixels being black";
        EXPECT_LT(errors.worst, most) << gather;
    }
}

// A black room with a window, through which a floor sees the bright background: rays to points of the window find its light without noise.
// What a point sees of it is its form factor, by Lambert's formula.
TEST_F(RadiosityGatherTest, LightThroughAWindowIsItsClosedFormAlongFewRays) {
    constexpr double kWidth = 4, kHeight = 2.5, kDepth = 4, kLeft = 1.2, kRight = 2.4, kSill = 1, kTop = 1.9;
    constexpr float kSky = 3, kReflects = 0.6f;
    scene::Scene scene = testing::emptyRoom({kWidth, kHeight, kDepth});
    scene.background = vec3(kSky);
    scene.materials.resize(2);
    scene.materials[0].diffuse = vec3(0.0f);
    scene.materials[1].diffuse = vec3(kReflects);
    scene.objects[0].partMaterials = {1}; // the floor
    scene.objects.erase(scene.objects.begin() + 2); // the wall z = 0; in its place four pieces of it
    const auto piece = [&](double left, double right, double below, double above) {
        testing::addObject(scene, scene::makeQuad({right - left, above - below}),
                           glm::rotate(testing::translation({(left + right) / 2, (below + above) / 2, 0}), glm::radians(90.0), dvec3(1, 0, 0)));
    };
    piece(0, kLeft, 0, kHeight);
    piece(kRight, kWidth, 0, kHeight);
    piece(kLeft, kRight, 0, kSill);
    piece(kLeft, kRight, kTop, kHeight);
    scene.camera.positionWorld = {2, 2.2, 2.001};
    scene.camera.targetWorld = {2, 0, 2};
    scene.camera.fovYDegrees = 75;
    const ivec2 size{32, 32};
    const radiosity::Polygon window{{kLeft, kSill, 0}, {kRight, kSill, 0}, {kRight, kTop, 0}, {kLeft, kTop, 0}};
    for (const auto& [gather, mostMean, most] : {std::tuple(std::string("gather=pixels"), 0.12, 0.5), {"gather=shared", 0.06, 0.25}}) {
        testing::TechniqueSlot radiosity("radiosity", testing::snapshot(scene));
        const std::vector<vec4> texels = radiosity.radiance({"patches=60", gather, "gather-samples=32"}, size);
        const FloorErrors errors = errorsOnFloor(texels, scene.camera, size, [&](const dvec3& point) {
            return static_cast<double>(kReflects * kSky) * radiosity::pointFormFactor(point, {0, 1, 0}, window); // rho / pi * pi L F
        });
        // Half of the chosen points lie beside the window, as cells do not end where it ends: found 0.08 and 0.05, and 0.3 and 0.2 at most.
        EXPECT_LT(errors.mean, mostMean) << gather << ": by rays in all directions alone it is 0.97 and 0.16";
        EXPECT_LT(errors.worst, most) << gather;
    }
}

constexpr int kBlock = 6;

/// Means of blocks of pixels, in which noise is a sixth.
std::vector<dvec3> blocksOf(const std::vector<vec4>& texels, ivec2 size) {
    std::vector<dvec3> means;
    for (int y = 0; y < size.y; y += kBlock)
        for (int x = 0; x < size.x; x += kBlock) {
            dvec3 sum(0);
            for (int i = 0; i < kBlock * kBlock; ++i)
                sum += dvec3(texels[static_cast<std::size_t>((y + i / kBlock) * size.x + x + i % kBlock)]);
            means.push_back(sum / static_cast<double>(kBlock * kBlock));
        }
    return means;
}

// The built-in room: collected by pixels it comes nearer to paths followed by chance.
TEST_F(RadiosityGatherTest, ComesNearerToPathsFollowedByChance) {
    const scene::Snapshot scene = scene::loadScene("cornell-room", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    const ivec2 size{96, 54};
    const std::vector<dvec3> paths = blocksOf(testing::TechniqueSlot("ray-traced", scene)
                                                  .radiance({"samples=1024", "interreflection=true", "antialias=false"}, size),
                                              size);
    const auto difference = [&](const std::string& gather) {
        const std::vector<dvec3> blocks = blocksOf(
            testing::TechniqueSlot("radiosity", scene).radiance({gather, "gather-samples=512"}, size), size);
        double sum = 0, squares = 0;
        int compared = 0;
        for (std::size_t i = 0; i < paths.size(); ++i) {
            if (paths[i].g > 0.5) continue; // the lamp, or a piece of it
            for (int c = 0; c < 3; ++c) {
                sum += paths[i][c];
                squares += std::pow(paths[i][c] - blocks[i][c], 2);
            }
            ++compared;
        }
        EXPECT_GT(compared, 60);
        return std::sqrt(squares * 3 * compared) / sum; // the root of the mean square, relative to the mean
    };
    const double interpolated = difference("gather=none"), gathered = difference("gather=pixels");
    EXPECT_LT(gathered, 0.02) << "the bound for rooms; half a hundredth of it is the scatter of paths";
    // Found: 0.0093 and 0.0142. Both hold the scatter of the paths, so their ratio cannot be that of the errors alone.
    EXPECT_LT(gathered, 0.85 * interpolated) << interpolated;
    EXPECT_LT(difference("gather=shared"), 0.02);
}

// In a picture of 512 rows one pixel of 64 gathers at first, and few follow, in corners and around the lamp, which hangs a little below the
// ceiling: there records beside it do not know of it. The picture is that of all pixels gathering.
TEST_F(RadiosityGatherTest, FewPixelsGatherForALargePicture) {
    const scene::Snapshot scene = scene::loadScene("cornell-room", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    const ivec2 size{516, 516}; // of whole blocks
    testing::TechniqueSlot radiosity("radiosity", scene);
    const std::vector<dvec3> shared = blocksOf(radiosity.radiance({"gather=shared"}, size), size);
    const double gathering = radiosity.counted({"gather=shared"}, size, "gathering");
    EXPECT_GT(gathering, size.x * size.y / 70);
    EXPECT_LT(gathering, size.x * size.y / 16);
    const std::vector<dvec3> all = blocksOf(radiosity.radiance({"gather=pixels", "gather-samples=48"}, size), size);
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        sum += all[i].g;
        squares += std::pow(all[i].g - shared[i].g, 2);
    }
    const double count = static_cast<double>(all.size());
    EXPECT_EQ(all.size(), 86u * 86u);
    // The aim is 0.02. Where a pixel takes over without a look at its neighbours, the ceiling beside the lamp is too bright, and it is 0.011.
    EXPECT_LT(std::sqrt(squares * count) / sum, 0.01);
}

/// Of the rows from a tenth to the middle of a picture, and there of the columns from 6 to 7.5 tenths, what is largest of: how much a pixel differs from the mean of those
/// so many before and behind it (RMS), over the mean of all.
double roughestRow(const std::vector<vec4>& texels, ivec2 size, int apart, double least) {
    double roughest = 0;
    for (int y = size.y / 10; y < size.y / 2; ++y) {
        double sum = 0, squares = 0;
        int count = 0;
        for (int x = 6 * size.x / 10; x < 3 * size.x / 4; ++x, ++count) {
            const auto at = [&](int column) { return static_cast<double>(texels[static_cast<std::size_t>(y * size.x + column)].g); };
            sum += at(x);
            squares += std::pow(at(x) - (at(x - apart) + at(x + apart)) / 2, 2);
        }
        EXPECT_GT(sum / count, least) << y;
        roughest = std::max(roughest, std::sqrt(squares * count) / sum);
    }
    return roughest;
}

// Where ceiling and wall meet, few pixels can take over from others, and each gathers along few rays. With their neighbours they make up for
// it: along a row of pixels light changes slowly there, and what changes from pixel to pixel is noise.
TEST_F(RadiosityGatherTest, CornersAreSmooth) {
    const scene::Snapshot scene = scene::loadScene("cornell-room", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    const ivec2 size{512, 512};
    const std::vector<vec4> texels = testing::TechniqueSlot("radiosity", scene).radiance({"gather=shared"}, size); // ceiling and back wall, beside lamp and blocks
    EXPECT_LT(roughestRow(texels, size, 1, 0.05), 0.035) << "it is 0.028; where no pixel takes over from the nearest ones it is 0.22";
}

// A small lamp is found by rays to chosen points, with more noise.
TEST_F(RadiosityGatherTest, CornersAreSmoothBesideASmallLamp) {
    scene::Scene scene = testing::emptyRoom({4, 3, 4});
    scene.materials.resize(2);
    scene.materials[0].diffuse = vec3(0.7f);
    scene.materials[1].emission = vec3(20);
    testing::addObject(scene, scene::makeSphere(0.12, 64), testing::translation({0.15, 1.8, 1.7})).partMaterials = {1};
    scene.camera.positionWorld = {2, 1.5, 3.9};
    scene.camera.targetWorld = {2, 1.5, 0};
    scene.camera.fovYDegrees = 70;
    const ivec2 size{512, 512};
    const std::vector<vec4> texels = testing::TechniqueSlot("radiosity", testing::snapshot(scene)).radiance({"gather=shared"}, size);
    EXPECT_LT(roughestRow(texels, size, 16, 0.01), 0.08) << "it is 0.069; where one record does on every lattice it is 0.093";
}

// A ground of a kilometre, on which colour bleeds a metre wide.
TEST_F(RadiosityGatherTest, OnAWideGroundColourBleedsAsFarAsItDoes) {
    scene::Scene scene;
    scene.background = vec3(0.05f, 0.06f, 0.08f);
    scene.materials.resize(2);
    scene.materials[0].diffuse = vec3(0.5f);
    scene.materials[1].diffuse = vec3(0.8f, 0.1f, 0.05f);
    testing::addObject(scene, scene::makeQuad({1000, 1000}), dmat4(1));
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({0, 0.5, 0}));
    scene.objects[1].partMaterials = {1};
    scene.lights.push_back(testing::directionalLight({-1, -0.6, -0.4}));
    scene.camera.positionWorld = {4, 3, 4};
    scene.camera.targetWorld = {0, 0.3, 0};
    scene.camera.fovYDegrees = 40;
    const ivec2 size{96, 54};
    const std::vector<dvec3> paths = blocksOf(testing::TechniqueSlot("ray-traced", testing::snapshot(scene))
                                                  .radiance({"samples=256", "interreflection=true", "antialias=false"}, size),
                                              size);
    const auto difference = [&](const std::string& gather) {
        const std::vector<dvec3> blocks =
            blocksOf(testing::TechniqueSlot("radiosity", testing::snapshot(scene)).radiance({gather}, size), size);
        double sum = 0, squares = 0;
        for (std::size_t i = 0; i < paths.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                sum += paths[i][c];
                squares += std::pow(paths[i][c] - blocks[i][c], 2);
            }
        EXPECT_EQ(paths.size(), 16u * 9u);
        return std::sqrt(squares * 3 * static_cast<double>(paths.size())) / sum;
    };
    EXPECT_LT(difference("gather=shared"), 0.01); // 0.03 is the bound for pictures of the open
    EXPECT_LT(difference("gather=none"), 0.01) << "near the box its patches are as small as the box's (ground.h)";
    // With a floor as wide beneath it, which nobody sees, it is no ground, and cut evenly: a patch of it has tens of metres. Interpolation
    // then knows nothing of the box. Pixels that share do.
    testing::addObject(scene, scene::makeQuad({1000, 1000}), testing::translation({0, -5, 0}));
    EXPECT_LT(difference("gather=shared"), 0.01);
    EXPECT_GT(difference("gather=none"), 0.02);
}

} // namespace
} // namespace shadowlab
