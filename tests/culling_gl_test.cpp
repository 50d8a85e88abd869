// What the parameter `cull` leaves out cannot be seen: the same bytes with it and without, in every built-in scene and in
// random ones.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "app/context/assets.h"
#include "app/lab/settings.h"
#include "app/picture/session.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/gl/scene/id_buffer.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/foundation/scene/query/view/picture_part.h"
#include "techniques/foundation/trace/judge/exact_visibility.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/random_scenes.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

constexpr ivec2 kSize{96, 64};
// Of thirteen kinds of maps each is tried ten times, of the others all in every scene; a thousand take minutes.
constexpr unsigned kRandomScenes = 65, kRandomScenesLong = 1000;
// Of the thousand, those with a receiver that is stretched askew, and shadows at an acute corner of it.
constexpr unsigned kAskew[] = {381, 631, 757};

struct Variant {
    std::string name, technique;
    std::vector<std::string> settings;
};

/// A technique with settings, once as it is and once with nothing left out. Its slots see all scenes, one after the other: what
/// they keep of one must not show in the next.
struct Culled {
    std::string name;
    std::vector<picture::Slot> slots = {}; ///< cull = true, cull = false
    int scenesWithLess = 0;                ///< in which something was left out

    explicit Culled(const Variant& variant) : name(variant.name) {
        for (const char* cull : {"cull=true", "cull=false"}) {
            slots.push_back(picture::Session::makeSlot(variant.technique));
            const std::string slot = std::to_string(slots.size()) + ":" + variant.technique + ".";
            std::vector<std::string> full = {slot + cull};
            for (const std::string& setting : variant.settings)
                full.push_back(slot + setting);
            lab::applySettings(slots, full);
        }
    }
};

std::vector<Culled> culled(const std::vector<Variant>& variants) {
    std::vector<Culled> all;
    for (const Variant& variant : variants)
        all.emplace_back(variant);
    return all;
}

struct Drawn {
    std::vector<vec4> picture;
    std::vector<vec4> visibility; ///< of the last light
    double built = 0;             ///< the technique's own count of what it drew for shadows
};

Drawn draw(picture::Session& session, picture::Slot& slot) {
    const scene::Scene& scene = *session.snapshot();
    View view;
    view.camera = scene.camera;
    view.size = kSize;
    FrameRequest request;
    if (!scene.lights.empty()) request.stages.push_back({"visibility", static_cast<int>(scene.lights.size()) - 1});
    const picture::RenderedFrame frame = session.render(slot, view, request);
    Drawn drawn{.picture = gl::readTexels(slot.target.color), .visibility = {}};
    for (const StageKey& stage : request.stages)
        drawn.visibility = gl::readTexels(picture::findStage(frame, stage).texture);
    for (const Counter& counter : frame.result.counters)
        if (counter.id == "volumes" || counter.id == "caster-draws" || counter.id == "flattened")
            drawn.built += counter.built;
    return drawn;
}

/// The pixels in which they differ.
std::vector<std::size_t> differing(const std::vector<vec4>& a, const std::vector<vec4>& b) {
    std::vector<std::size_t> pixels;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i] != b[i]) pixels.push_back(i);
    return pixels;
}

/// Which pixels show a triangle that the ray through their centre misses: the rasteriser moves corners to 1/256 of a pixel, and
/// so a rim a little outward. The point that is seen there lies beyond that rim, on a surface that has ended, and no answer is
/// right: the sides of a volume that begin at the rim lie behind such a point or before it, as rounding will have it. With the
/// volume left out there is nothing to round.
class Rims {
public:
    explicit Rims(const scene::Snapshot& snapshot) : judge_(snapshot), camera_(snapshot->camera) {
        buffers_.update(snapshot);
        gl::IdBuffer idBuffer;
        idBuffer.draw(*snapshot, buffers_, gl::eyeMatrices(camera_, kSize), kSize);
        ids_ = idBuffer.read();
    }
    [[nodiscard]] bool beyond(std::size_t pixel) const {
        const dvec2 centre = dvec2(pixel % kSize.x, pixel / kSize.x) + 0.5;
        const auto hit = judge_.eyeHit(camera_, centre, kSize);
        return ids_[pixel] != gl::IdBuffer::kNone &&
               (!hit || static_cast<std::uint32_t>(buffers_.triangleBase(hit->object)) + hit->triangle != ids_[pixel]);
    }

private:
    gl::SceneBuffers buffers_;
    trace::ExactVisibility judge_;
    scene::Camera camera_;
    std::vector<std::uint32_t> ids_;
};

class CullingTest : public testing::GlTest {
protected:
    /// The number of pixels compared.
    std::size_t compare(const scene::Snapshot& snapshot, Culled& culled, const std::string& what) {
        picture::Session session(snapshot);
        const Drawn with = draw(session, culled.slots[0]), without = draw(session, culled.slots[1]);
        culled.scenesWithLess += with.built < without.built;
        EXPECT_LE(with.built, without.built) << what;
        const std::size_t wrong = outsideRims(snapshot, differing(with.picture, without.picture), what) +
                                  outsideRims(snapshot, differing(with.visibility, without.visibility), what);
        EXPECT_EQ(wrong, 0u) << culled.name << ", pixels of the picture and of the visibility in " << what;
        return with.picture.size() + with.visibility.size();
    }

    /// Pixels beyond a rim (see Rims) in which a picture differed: each as the name of its scene and its number.
    std::set<std::pair<std::string, std::size_t>> beyondRims_;

private:
    std::size_t outsideRims(const scene::Snapshot& snapshot, const std::vector<std::size_t>& pixels,
                            const std::string& what) {
        if (pixels.empty()) return 0;
        const Rims rims(snapshot);
        std::size_t count = 0;
        for (const std::size_t pixel : pixels)
            if (rims.beyond(pixel))
                beyondRims_.emplace(what, pixel);
            else
                ++count;
        return count;
    }
};

std::vector<Variant> volumesAndPlanes() {
    return {{"planar", "planar", {}},
            {"z-pass", "shadow-volume-zpass", {}},
            {"z-pass, corrected", "shadow-volume-zpass", {"eye-correction=true"}},
            {"z-pass, to infinity", "shadow-volume-zpass", {"eye-correction=true", "volume-end=infinity"}},
            {"z-fail", "shadow-volume-zfail", {}},
            {"z-fail, to infinity", "shadow-volume-zfail", {"volume-end=infinity"}},
            {"chosen, repaired", "shadow-volume", {}}};
}

/// Small maps: their texels are large, and kernels reach far.
std::vector<Variant> maps() {
    std::vector<Variant> all;
    for (const char* settings :
         {"filter=hard", "filter=pcf", "filter=pcf fit=scene", "filter=disc", "filter=pcss", "filter=vsm",
          "filter=evsm", "filter=msm", "filter=pcf cascades=3", "filter=hard warp=lispsm",
          "filter=pcf bias-mode=slope-scaled", "filter=hard bias-mode=dual-depth"}) {
        Variant variant{std::string("map, ") + settings, "shadow-map", {"resolution=128"}};
        std::istringstream words(settings);
        for (std::string word; words >> word;)
            variant.settings.push_back(word);
        all.push_back(std::move(variant));
    }
    all.push_back({"exact map", "shadow-map-exact", {"resolution=128"}});
    return all;
}

/// A flat caster behind which there is nothing: volumes of it count nothing, but in a map it would shadow itself, which is why
/// maps leave it out, and what cull = false is there to show. So here it is no caster.
scene::Snapshot withoutUselessCasters(scene::Scene scene) {
    std::vector<int> useful(scene.objects.size());
    for (const scene::Light& light : scene.lights)
        for (const std::size_t caster : scene::usefulCasters(scene, light))
            ++useful[caster];
    for (std::size_t o = 0; o < scene.objects.size(); ++o)
        if (useful[o] < static_cast<int>(scene.lights.size())) scene.objects[o].castsShadow = false;
    scene.revisions = {};
    return testing::snapshot(std::move(scene));
}

/// A face of an object that is stretched askew has no right angles.
TEST_F(CullingTest, ShadowsReachTheAcuteCornersOfAskewReceivers) {
    Culled planar(Variant{"planar", "planar", {}});
    for (const unsigned number : kAskew)
        EXPECT_GE(compare(testing::snapshot(testing::randomScene(number)), planar, "scene " + std::to_string(number)),
                  std::size_t{2} * kSize.x * kSize.y);
    EXPECT_GE(planar.scenesWithLess, 1);
}

/// The classic mistake: what is not in view casts no shadow.
scene::Snapshot withoutCastersOutOfView(scene::Scene scene) {
    const double aspect = static_cast<double>(kSize.x) / kSize.y;
    const dmat4 clipFromWorld = scene::clipFromView(scene.camera, aspect) * scene::viewFromWorld(scene.camera);
    for (scene::Object& object : scene.objects)
        if (!scene::mayTouch(scene::boundsWorld(object), clipFromWorld, scene::PicturePart{}))
            object.castsShadow = false;
    scene.revisions = {};
    return testing::snapshot(std::move(scene));
}

TEST_F(CullingTest, NothingThatIsLeftOutIsSeenInRandomScenes) {
    const unsigned scenes = std::getenv("SHADOWLAB_LONG") ? kRandomScenesLong : kRandomScenes;
    std::vector<Culled> always = culled(volumesAndPlanes()), inTurn = culled(maps());
    std::size_t compared = 0, mapScenes = 0;
    for (unsigned number = 0; number < scenes; ++number) {
        const scene::Scene scene = testing::randomScene(number);
        const scene::Snapshot snapshot = testing::snapshot(scene), forMaps = withoutUselessCasters(scene);
        const std::string what = "scene " + std::to_string(number);
        for (Culled& each : always)
            compared += compare(snapshot, each, what);
        for (unsigned i = 0; i < 2; ++i, ++mapScenes)
            compared += compare(forMaps, inTurn[(2 * number + i) % inTurn.size()], what);
    }
    // A rim has some hundred pixels, of which one in a few hundred is beyond it; and in few scenes anything is left out that
    // begins at the rim of a surface in view. Of the first thousand scenes eleven have such pixels.
    EXPECT_LE(beyondRims_.size(), std::size_t{1} + scenes / 50);
    // Nine comparisons of a picture and at least one visibility each.
    EXPECT_GE(compared, std::size_t{9} * 2 * kSize.x * kSize.y * scenes);
    for (const Culled& each : always)
        EXPECT_GE(each.scenesWithLess, static_cast<int>(scenes / 2))
            << each.name << " leaves out too little to prove anything";
    int withLess = 0;
    for (const Culled& each : inTurn)
        withLess += each.scenesWithLess;
    EXPECT_GE(withLess, static_cast<int>(mapScenes / 4)) << "maps leave out too little to prove anything";
}

TEST_F(CullingTest, NothingThatIsLeftOutIsSeenInBuiltInScenes) {
    std::vector<Culled> all = culled(volumesAndPlanes());
    std::vector<Culled> ofMaps = culled({{"map", "shadow-map", {}}, {"map, hard", "shadow-map", {"filter=hard"}}});
    const scene::LoadOptions options{.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}};
    int compared = 0;
    for (const std::string& name : scene::builtInScenes(options.assetsRoot)) {
        const scene::Snapshot snapshot = scene::loadScene(name, options);
        if (snapshot->lights.empty()) continue;
        for (Culled& each : all)
            compare(snapshot, each, name);
        const scene::Snapshot forMaps = withoutUselessCasters(*snapshot);
        for (Culled& each : ofMaps)
            compare(forMaps, each, name);
        ++compared;
    }
    EXPECT_GE(compared, 10);
    EXPECT_EQ(beyondRims_.size(), 0u);
}

/// Would the comparison see a cull that leaves out too much?
TEST_F(CullingTest, LeavingOutWhatIsNotInViewIsSeen) {
    constexpr unsigned kScenes = 60;
    picture::Slot slot = picture::Session::makeSlot("shadow-volume-zfail");
    int seen = 0;
    for (unsigned number = 0; number < kScenes; ++number) {
        const scene::Scene scene = testing::randomScene(number);
        picture::Session right(testing::snapshot(scene)), naive(withoutCastersOutOfView(scene));
        seen += !differing(draw(right, slot).picture, draw(naive, slot).picture).empty();
    }
    EXPECT_GE(seen, 3) << "of " << kScenes << " scenes";
}

} // namespace
} // namespace shadowlab
