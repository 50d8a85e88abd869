// Hard cases of what the eye does: it sees near things large and far ones small, and it moves.
//   M7 duelling frusta  CascadesKeepTexelsSmallerThanPixels; naive: cascades=1 fit=scene
//   M8 swimming         ShadowsStandStillWhileTheEyeMoves, ShadowsStandStillWhileTheEyeTurns; naive: stable=false
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/lab/settings.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/plane_view.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using trace::Visibility;

constexpr ivec2 kSize{256, 192};

constexpr double kTable = 12; // metres: side of what is looked at from above

class HardCascadesTest : public testing::GlTest {
protected:
    static picture::Slot slotWith(const std::vector<std::string>& settings) {
        std::vector<picture::Slot> slots;
        slots.push_back(picture::Session::makeSlot("shadow-map"));
        std::vector<std::string> full;
        for (const std::string& setting : settings)
            full.push_back("shadow-map." + setting);
        lab::applySettings(slots, full);
        return std::move(slots[0]);
    }
    static View viewOf(const scene::Camera& camera, ivec2 size) {
        View view;
        view.camera = camera;
        view.size = size;
        return view;
    }
    static picture::VisibilityImage visibility(picture::Session& session, picture::Slot& slot, const View& view) {
        FrameRequest request;
        request.stages = {{"visibility", 0}};
        return picture::readVisibility(picture::findStage(session.render(slot, view, request), {"visibility", 0}));
    }
};

constexpr double kNearest = 0.5, kFarthest = 500;

/// A plain from half a metre to half a kilometre before the eye, upright boards on it near and far, and the sun in the eye's
/// back: it shines exactly the way the eye looks.
scene::Scene plain() {
    scene::Scene scene = testing::floorScene();
    scene.objects[0].mesh = scene::sharedMesh(scene::makeQuad({300, 2 * kFarthest}));
    scene.camera.positionWorld = {0, 0.3, 0};
    scene.camera.targetWorld = {0, 0.25, -1};
    scene.lights.push_back(testing::directionalLight(scene.camera.targetWorld - scene.camera.positionWorld));
    constexpr int kBoards = 24;
    for (int i = 0; i < kBoards; ++i) {
        const double z = 1.2 * kNearest * std::pow(0.8 * kFarthest / kNearest, i / (kBoards - 1.0));
        const double left = (i % 2 ? 0.4 : -0.5) * z, right = left + 0.1 * z, top = 0.06 * z;
        testing::addObject(
            scene,
            testing::triangleSoup(
                {{left, 0, -z}, {right, 0, -z}, {right, top, -z}, {left, 0, -z}, {right, top, -z}, {left, top, -z}}));
    }
    return scene;
}

class DuellingFrustaTest : public HardCascadesTest {
protected:
    /// The largest texel, in pixels, on the boards or on the floor: inside of what is seen of each, because at its edge the
    /// rasteriser may take the surface beside it.
    static double largestTexelPx(const scene::Scene& scene, bool onBoards, ivec2 size,
                                 const std::vector<std::string>& settings) {
        picture::Session session(testing::snapshot(scene));
        picture::Slot slot = slotWith(settings);
        const View view = viewOf(scene.camera, size);
        FrameRequest request;
        request.stages = {{"texel-size", 0}};
        const picture::RenderedFrame rendered = session.render(slot, view, request);
        const std::vector<vec4> texels = gl::readTexels(picture::findStage(rendered, {"texel-size", 0}).texture);
        const judge::Truth truth = session.truthAtCentres(view, 0);
        const auto objectAt = [&](int x, int y) { return truth.objects[truth.index(x, y)]; };
        double largest = 0;
        int lit = 0;
        for (int y = 1; y + 1 < size.y; ++y)
            for (int x = 1; x + 1 < size.x; ++x) {
                const std::uint32_t object = objectAt(x, y);
                const vec4& texel = texels[truth.index(x, y)];
                if ((object != 0) != onBoards || texel.g < 0.5f) continue;
                if (objectAt(x - 1, y) != object || objectAt(x + 1, y) != object || objectAt(x, y - 1) != object ||
                    objectAt(x, y + 1) != object)
                    continue;
                largest = std::max<double>(largest, texel.r);
                lit += truth.visibility[truth.index(x, y)] == Visibility::lit;
            }
        EXPECT_GT(lit, 500);
        return largest;
    }
};

// M7. A cascade from n to r n has to be as wide as what is seen of its far end: W r n / f metres, in a picture W pixels wide
// with a focal length of f pixels. At its near end so many metres are W r pixels, and one of its texels is W r / resolution
// pixels large; around a ball, which is as wide as the far end's diagonal, 5/4 of that at 4:3. Four cascades for 1:1000 have
// r = 1000^(1/4) = 5.6. So of 2048 texels none is larger than a pixel as long as W is at most 2048 / (5.6 * 5/4) = 290. At
// 1024 x 768 they measure up to 3.5 pixels; for one pixel r would have to be 2 even without balls, which takes ten cascades.
//
// So much for surfaces that face the sun, such as the boards. The floor before its feet the eye sees from far steeper than the
// sun shines on it, and there texels are longer by the ratio of the two sines.
TEST_F(DuellingFrustaTest, CascadesKeepTexelsSmallerThanPixels) {
    const scene::Scene scene = plain();
    const std::vector<std::string> cascades = {"cascades=4", "split-mix=1"}, naive = {"cascades=1", "fit=scene"};
    const auto largest = [&](const char* what, const std::vector<std::string>& settings, ivec2 size) {
        const double boards = largestTexelPx(scene, true, size, settings);
        std::cout << what << ", " << size.x << " pixels wide: texels of up to " << boards << " px on the boards, "
                  << largestTexelPx(scene, false, size, settings) << " px on the floor\n";
        return boards;
    };
    EXPECT_LE(largest("four cascades", cascades, kSize), 1);
    // So few pixels show less of the plain than there is; this shares out all of it.
    EXPECT_LE(largest("the same, 1:1000", {"cascades=4", "split-mix=1", "depth-bounds=camera"}, kSize), 1);
    EXPECT_LE(largest("four cascades", cascades, {1024, 768}), 3.5);
    EXPECT_GT(largest("one map", naive, kSize), 20);
    // Nothing to gain by a warp: it makes texels smaller toward the eye, which here is where the light comes from.
    EXPECT_GT(largest("one warped map", {"warp=lispsm"}, kSize), 20);
}

// No edge of a shadow is farther off than a pixel, near or far.
TEST_F(DuellingFrustaTest, ShadowsEndWithinAPixel) {
    const testing::JudgedPicture judged(testing::snapshot(plain()), kSize, 0, 1.0);
    const auto compare = [&](const std::vector<std::string>& settings) {
        const testing::TruthComparison sum =
            judged.compare(testing::renderVisibility(judged.snapshot(), "shadow-map", settings, kSize, 0));
        std::cout << settings[0] << " " << settings[1] << ": " << sum << "\n";
        return sum;
    };
    const testing::TruthComparison cascades = compare({"cascades=4", "split-mix=1"});
    EXPECT_GT(cascades.lit, 5000);
    EXPECT_GT(cascades.shadowed, 1000);
    EXPECT_EQ(cascades.wrong(), 0) << cascades;
    EXPECT_GT(compare({"cascades=1", "fit=scene"}).wrong(), 500);
}

/// Boxes turned in all ways over a wide plain, of which the middle is a table forty metres above the rest: so there is a range
/// of depths for cascades to share out, and none of them can hold everything.
scene::Scene grove() {
    scene::Scene scene = testing::floorScene();
    scene.objects[0].mesh = scene::sharedMesh(scene::makeQuad({kTable, kTable}));
    testing::addObject(scene, scene::makeQuad({400, 400}), testing::translation({0, -40, 0}));
    scene.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
    for (int x = -12; x <= 12; ++x)
        for (int z = -12; z <= 12; ++z) {
            const double angle = 0.7 * x + 1.3 * z;
            dmat4 place = testing::translation({3 * x + std::sin(angle), 0.75, 3 * z + 1.5 + std::cos(2 * angle)});
            place[0] = {std::cos(angle), 0, -std::sin(angle), 0};
            place[2] = {std::sin(angle), 0, std::cos(angle), 0};
            testing::addObject(scene, scene::makeBox({0.4, 1.5, 0.6}), place);
        }
    return scene;
}

/// How often a place on the table changes between lit and dark from one picture to the next, seen from straight above: an eye
/// is somewhere over it, and turned about the vertical. Counted on the screen, stable and naive maps hardly differ: when the
/// eye moves, the stairs of every edge move over the pixels, whether they stand still on the ground or not.
class Swimming {
public:
    struct Eye {
        dvec2 over{0.0};
        double turnDegrees = 0;
    };
    int flips = 0, places = 0, shadowed = 0;
    [[nodiscard]] double share() const { return static_cast<double>(flips) / places; }

    void add(const Eye& eye, picture::VisibilityImage image) {
        for (int y = 0; before_ && y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x) {
                const dvec2 place = placeOf(eye, dvec2(x + 0.5, y + 0.5));
                if (std::max(std::abs(place.x), std::abs(place.y)) > 0.5 * kTable) continue;
                const dvec2 then = pixelOf(beforeEye_, place) - 0.5;
                const ivec2 nearest(glm::round(then));
                // Only places that are at a pixel's centre both times: so the picture's own raster has no part in it.
                if (glm::length(then - dvec2(nearest)) > 0.05) continue;
                if (nearest.x < 0 || nearest.y < 0 || nearest.x >= kSize.x || nearest.y >= kSize.y) continue;
                ++places;
                shadowed += image.grey(x, y) <= 127;
                flips += (image.grey(x, y) > 127) != (before_->grey(nearest.x, nearest.y) > 127);
            }
        before_ = std::move(image);
        beforeEye_ = eye;
    }
    static scene::Camera cameraOf(const Eye& eye) {
        scene::Camera camera = testing::PlaneView{eye.over, kPixelsPerMetre, kSize}.camera();
        const double angle = glm::radians(eye.turnDegrees);
        camera.upWorld = {std::sin(angle), 0, -std::cos(angle)};
        return camera;
    }
    static constexpr double kPixelsPerMetre = 16; // a step of one pixel is a number without rounding

private:
    /// Place on the plane (x, z) that a pixel shows, and back: turned about the middle of the picture.
    static dvec2 placeOf(const Eye& eye, const dvec2& pixel) {
        return eye.over + turned((pixel - 0.5 * dvec2(kSize)) / kPixelsPerMetre, eye.turnDegrees);
    }
    static dvec2 pixelOf(const Eye& eye, const dvec2& place) {
        return 0.5 * dvec2(kSize) + kPixelsPerMetre * turned(place - eye.over, -eye.turnDegrees);
    }
    static dvec2 turned(const dvec2& v, double degrees) {
        const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
        return {c * v.x - s * v.y, s * v.x + c * v.y};
    }
    std::optional<picture::VisibilityImage> before_;
    Eye beforeEye_;
};

class SwimmingTest : public HardCascadesTest {
protected:
    template <typename EyeAt>
    static Swimming swimming(const std::string& stable, const EyeAt& eyeAt) {
        picture::Session session(testing::snapshot(grove()));
        picture::Slot slot = slotWith({stable, "cascades=4", "filter=hard", "resolution=128"});
        Swimming result;
        for (int step = 0; step < 24; ++step)
            result.add(eyeAt(step), visibility(session, slot, viewOf(Swimming::cameraOf(eyeAt(step)), kSize)));
        std::cout << stable << ": " << result.flips << " flips at " << result.places << " places, of which "
                  << result.shadowed << " in shadow: " << 100 * result.share() << " %\n";
        EXPECT_GT(result.shadowed, 500);
        EXPECT_GT(result.places - result.shadowed, 500);
        return result;
    }
};

// M8. By whole pixels, so that every place is at a pixel's centre both times; that is by about 0.3 texels.
TEST_F(SwimmingTest, ShadowsStandStillWhileTheEyeMoves) {
    const auto eyeAt = [](int step) { return Swimming::Eye{{step / Swimming::kPixelsPerMetre, 0}, 0}; };
    const Swimming stable = swimming("stable=true", eyeAt), naive = swimming("stable=false", eyeAt);
    EXPECT_EQ(stable.flips, 0);
    EXPECT_GT(naive.share(), 0.005);
}

// One degree after the other, and each of them also a right angle farther: then every pixel's centre is a pixel's centre again.
TEST_F(SwimmingTest, ShadowsStandStillWhileTheEyeTurns) {
    const auto eyeAt = [](int step) { return Swimming::Eye{{0.25, 0.125}, 1.0 * (step / 2) + (step % 2 ? 90 : 0)}; };
    const Swimming stable = swimming("stable=true", eyeAt), naive = swimming("stable=false", eyeAt);
    EXPECT_LT(stable.share(), 0.0005); // rounding: centres that lie on a texel's very border
    EXPECT_GT(naive.share(), 0.005);
}

} // namespace
} // namespace shadowlab
