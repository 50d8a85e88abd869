// Hard cases of where maps meet, and of numbers that are large or small.
//   M10 seams of six maps    NoMoreErrorsWhereTwoMapsMeet, which paints seams to show that it would notice;
//       AllErrorsAmidTheCastersAreNearEdges; naive: cube-seams=bare
//   M18 far from the origin  MovedByAMillionMetresThePictureIsTheSame; naive: coordinates=world
//   M19 tiny and huge        AScaleChangesNothing; naive: bias-mode=constant with bias-unit=metres
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/shadow_map/edge_reach.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using testing::JudgedPicture;
using testing::TruthComparison;
using HardSeamsTest = testing::GlTest;

constexpr ivec2 kSize{256, 192};

constexpr double kLampHeight = 1;
constexpr int kPosts = 24;

/// A lamp over a floor within a ring of thin posts, seen from straight above; the whole ring turned by so many degrees. It
/// looks the same after each turn by 15 degrees, but only every third post stands where two maps meet.
scene::Scene lampAmidPosts(double turnDegrees) {
    scene::Scene scene = testing::floorScene();
    scene.lights.push_back(testing::pointLight({0, kLampHeight, 0}));
    for (int i = 0; i < kPosts; ++i) {
        const double angle = glm::radians(360.0 * i / kPosts + turnDegrees), c = std::cos(angle), s = std::sin(angle);
        dmat4 place = testing::translation({0.6 * c, 0.6, 0.6 * s});
        place[0] = {c, 0, s, 0};
        place[2] = {-s, 0, c, 0};
        // A degree wide, as seen from the lamp: with 128 texels two of them where they are smallest.
        testing::addObject(scene, scene::makeBox({0.0105, 1.2, 0.0105}), place);
    }
    scene.camera.positionWorld = {0, 9, 0};
    scene.camera.upWorld = {0, 0, -1};
    scene.camera.fovYDegrees = 55;
    return scene;
}

/// A band of the floor, and bands of its shape where nothing meets.
enum class Band { seam, elsewhere, none };

/// Two maps beside each other meet below |x| = |z|. Elsewhere: the same turned by 30 degrees to both sides, two posts on.
Band besideBand(const dvec3& at, int resolution) {
    const double width = 2 * 2.0 / resolution; // radians: two texels, each 2 / resolution in the tangent's half
    const double radius = std::hypot(at.x, at.z);
    if (radius < 0.8 || radius > 4) return Band::none;
    const double fromSeam = std::abs(std::remainder(std::atan2(at.z, at.x) - M_PI / 4, M_PI / 2));
    return fromSeam < width / 2 ? Band::seam : std::abs(fromSeam - M_PI / 6) < width / 2 ? Band::elsewhere : Band::none;
}

/// The map that looks down meets the other four below a square as far from the lamp's foot as the lamp is high. Elsewhere:
/// squares a fifth smaller and larger.
Band belowBand(const dvec3& at, int resolution) {
    const double side = std::max(std::abs(at.x), std::abs(at.z)), width = kLampHeight * 4.0 / resolution;
    if (std::abs(side - kLampHeight) < width) return Band::seam;
    return std::abs(std::abs(side - kLampHeight) - 0.2) < width ? Band::elsewhere : Band::none;
}

/// Share of wrong pixels in both kinds of band.
struct Density {
    int wrong[2] = {}, all[2] = {};
    [[nodiscard]] double of(Band band) const {
        const auto i = static_cast<std::size_t>(band);
        return static_cast<double>(wrong[i]) / std::max(1, all[i]);
    }
    [[nodiscard]] double ratio() const { return of(Band::seam) / of(Band::elsewhere); }
};
std::ostream& operator<<(std::ostream& stream, const Density& d) {
    return stream << "at seams " << d.wrong[0] << " wrong of " << d.all[0] << ", elsewhere " << d.wrong[1] << " of "
                  << d.all[1] << ", ratio " << d.ratio();
}

/// `line`: one pixel in four of the seams is turned over first, to show that the test would notice.
template <typename BandOf>
void addDensity(const JudgedPicture& judged, const picture::VisibilityImage& image, bool line, const BandOf& bandOf,
                Density& density) {
    for (int y = 0; y < judged.size().y; ++y)
        for (int x = 0; x < judged.size().x; ++x) {
            if (!judged.hit(x, y) || judged.hit(x, y)->object != 0) continue;
            const Band band = bandOf(judged.hit(x, y)->positionWorld);
            if (band == Band::none) continue;
            const bool flip = line && band == Band::seam && (x + 2 * y) % 4 == 0;
            const bool lit = (image.grey(x, y) > 127) != flip;
            ++density.all[static_cast<std::size_t>(band)];
            density.wrong[static_cast<std::size_t>(band)] += lit != (judged.truth(x, y) == trace::Visibility::lit);
        }
}

// M10. Coarse maps are wrong along every edge of a shadow; where two of them meet they must not be wrong more often. Posts are
// tried in many places between the texels, because where one happens to be decides how wrong it is.
TEST_F(HardSeamsTest, NoMoreErrorsWhereTwoMapsMeet) {
    constexpr int kResolution = 128;
    const auto beside = [](const dvec3& at) { return besideBand(at, kResolution); };
    const auto below = [](const dvec3& at) { return belowBand(at, kResolution); };
    std::vector<JudgedPicture> pictures;
    for (int i = -6; i <= 6; ++i)
        pictures.emplace_back(testing::snapshot(lampAmidPosts(0.1 * i)), ivec2(400, 400), 0, testing::kTiePx);
    for (const std::string filter : {"filter=hard", "pcf-radius=1", "pcf-radius=3"}) {
        Density densities[2], withLine[2];
        for (const JudgedPicture& judged : pictures) {
            const auto image =
                testing::renderVisibility(judged.snapshot(), "shadow-map",
                                          {filter, "resolution=" + std::to_string(kResolution)}, judged.size(), 0);
            addDensity(judged, image, false, beside, densities[0]);
            addDensity(judged, image, false, below, densities[1]);
            addDensity(judged, image, true, beside, withLine[0]);
            addDensity(judged, image, true, below, withLine[1]);
        }
        for (const int i : {0, 1}) {
            std::cout << filter << (i == 0 ? ", maps beside each other: " : ", map below: ") << densities[i]
                      << "; with a line " << withLine[i].ratio() << "\n";
            EXPECT_GT(densities[i].all[0], 5000);
            EXPECT_GT(densities[i].wrong[1], 200);
            EXPECT_LE(densities[i].ratio(), 1.2) << filter;
            // A kernel of 7 x 7 texels loses half of such thin shadows, and turning pixels over at random changes nothing.
            if (filter == "filter=hard") {
                EXPECT_GT(withLine[i].ratio(), 1.2);
            }
        }
    }
}

// The same with ordinary casters: whatever is wrong lies within the reach of a comparison, or of the kernel, from an edge.
TEST_F(HardSeamsTest, AllErrorsAmidTheCastersAreNearEdges) {
    scene::Scene scene = testing::floorScene();
    scene.lights.push_back(testing::pointLight({0, 1, 0}));
    // Across the diagonals, where two of the six maps meet.
    for (const dvec3 at : {dvec3(1, 0.5, 1), dvec3(-1, 0.5, 1), dvec3(1, 0.5, -1), dvec3(-1, 0.5, -1)})
        testing::addObject(scene, scene::makeBox({0.5, 0.5, 0.5}), testing::translation(at));
    const auto snapshot = testing::snapshot(scene);
    for (const auto& [filter, texels] : {std::pair{"filter=hard", 1.5}, std::pair{"pcf-radius=3", 7.0}}) {
        const TruthComparison sum =
            testing::compareWithTruth(snapshot, "shadow-map", {filter, "resolution=1024"}, kSize, 0,
                                      testing::edgeReach(snapshot, 0, 1024, kSize, texels));
        EXPECT_GT(sum.lit, 5000);
        EXPECT_GT(sum.shadowed, 500);
        EXPECT_EQ(sum.wrong(), 0) << sum;
        EXPECT_LT(sum.ties, sum.compared / 20) << "edges everywhere: the test says nothing";
    }
    // Where maps end at the seams, a kernel finds up to half of its texels beyond them: a line of light in what is all shadow.
    const std::vector<std::string> settings{"pcf-radius=3", "resolution=1024"};
    const auto guarded = testing::renderVisibility(snapshot, "shadow-map", settings, kSize, 0);
    const auto bare =
        testing::renderVisibility(snapshot, "shadow-map", {settings[0], settings[1], "cube-seams=bare"}, kSize, 0);
    int dark = 0, brighter = 0;
    for (std::size_t i = 0; i < guarded.greyAlpha.size(); i += 2) {
        const bool isDark = guarded.greyAlpha[i] == 0 && guarded.greyAlpha[i + 1] == 255;
        dark += isDark ? 1 : 0;
        brighter += isDark && bare.greyAlpha[i] > 25 ? 1 : 0; // more than a tenth of the light
    }
    EXPECT_GT(dark, 5000);
    EXPECT_GT(brighter, 50);
}

// M18. Every coordinate is a multiple of 2^-9 or a float in a mesh of its own, so the scene can be moved without rounding:
// the picture has to be the same byte for byte. Single precision, which steps by 1/16 m there, would shake everything.
TEST_F(HardSeamsTest, MovedByAMillionMetresThePictureIsTheSame) {
    scene::Scene scene = testing::simpleScene();
    scene.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
    scene.lights.push_back(testing::pointLight({0.25, 0.5, -0.25})); // amid the casters: six maps
    const auto here = testing::snapshot(scene), there = testing::snapshot(testing::moved(scene, {1e6, 0, 1e6}));
    for (int light = 0; light < 3; ++light)
        for (const std::string cascades : {"cascades=1", "cascades=4"}) {
            if (light != 1 && cascades != "cascades=1") continue;
            const auto a = testing::renderVisibility(here, "shadow-map", {cascades}, kSize, light);
            const auto b = testing::renderVisibility(there, "shadow-map", {cascades}, kSize, light);
            int differing = 0, lit = 0;
            for (std::size_t i = 0; i < a.greyAlpha.size(); i += 2)
                differing += a.greyAlpha[i] != b.greyAlpha[i], lit += a.greyAlpha[i] > 127;
            EXPECT_GT(lit, 5000);
            EXPECT_LT(lit, 45000);
            EXPECT_EQ(differing, 0) << "light " << light << ", " << cascades;

            const auto naive =
                testing::renderVisibility(there, "shadow-map", {cascades, "coordinates=world"}, kSize, light);
            int shaken = 0;
            for (std::size_t i = 0; i < a.greyAlpha.size(); i += 2)
                shaken += a.greyAlpha[i] != naive.greyAlpha[i];
            EXPECT_GT(shaken, 500) << "light " << light << ", " << cascades;
        }
}

// M19. The truth is found anew at each scale; what the map gets wrong near edges stays the same but for rounding.
TEST_F(HardSeamsTest, AScaleChangesNothing) {
    scene::Scene scene = testing::simpleScene();
    scene.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
    for (const double x : {-4.0, 4.0}) // small, but the map is as wide as their distance, and its texels large
        testing::addObject(scene, scene::makeBox({0.2, 0.2, 0.2}), testing::translation({x, 0.1, x}));
    const std::vector<std::vector<std::string>> right = {{"filter=hard"}, {"filter=pcf"}, {"cascades=4"}};
    const std::vector<std::string> metres = {"filter=hard", "bias-mode=constant", "bias-unit=metres",
                                             "constant-bias=0.1"};
    for (const int light : {0, 1}) {
        std::vector<JudgedPicture> judged; // as it is, tiny, huge
        for (const double factor : {1.0, 1e-4, 1e4})
            judged.emplace_back(testing::snapshot(testing::scaled(scene, factor)), kSize, light, testing::kTiePx);
        const auto wrong = [&](std::vector<std::string> settings) {
            settings.push_back("resolution=64");
            std::vector<int> counts;
            for (const JudgedPicture& picture : judged) {
                const auto image = testing::renderVisibility(picture.snapshot(), "shadow-map", settings, kSize, light);
                const TruthComparison sum = picture.compare(image);
                EXPECT_GT(sum.lit, 5000);
                EXPECT_GT(sum.shadowed, 500);
                counts.push_back(picture.differing(image));
            }
            std::cout << "light " << light << ", " << settings[0] << ", " << settings[1] << ": " << counts[0]
                      << " wrong, x 1e-4 " << counts[1] << ", x 1e4 " << counts[2] << "\n";
            return counts;
        };
        for (const std::vector<std::string>& settings : right) {
            const std::vector<int> counts = wrong(settings);
            EXPECT_GT(counts[0], 50);
            // One in a hundred, and two pixels for those that lie on a texel's very border.
            EXPECT_NEAR(counts[1], counts[0], 0.01 * counts[0] + 2);
            EXPECT_NEAR(counts[2], counts[0], 0.01 * counts[0] + 2);
        }
        const std::vector<int> counts = wrong(metres);
        EXPECT_GT(counts[1], 2 * counts[0]); // everything is smaller than the bias: no shadows
        EXPECT_GT(counts[2], 2 * counts[0]); // a hundredth of a millimetre: no bias
    }
}

} // namespace
} // namespace shadowlab
