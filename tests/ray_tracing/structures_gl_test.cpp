// The picture does not depend on the structure that its rays are asked of; and what is shown of the structure.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <map>

#include "app/picture/picture.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/ray_tracing/structures/structure_cache.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using RayStructuresTest = testing::GlTest;

constexpr const char* kExact[] = {"none", "object-spheres", "object-boxes", "groups", "sphere-tree", "bvh", "grid"};
constexpr std::size_t kTrees = 4; ///< from here on not every triangle of an object is tried

void choose(picture::Slot& slot, const char* structure) {
    params::setFromText(params::find(slot.params, "structure", "ray-traced"), structure, "ray-traced");
}

struct Shown {
    image::Image picture;
    std::vector<std::vector<std::uint8_t>> visibility; ///< per light
    friend bool operator==(const Shown&, const Shown&) = default;
};

View viewOf(const scene::Scene& scene, ivec2 size) {
    View view;
    view.camera = scene.camera;
    view.size = size;
    return view;
}

Shown show(picture::Session& session, picture::Slot& slot, ivec2 size) {
    FrameRequest request;
    const int lights = static_cast<int>(session.snapshot()->lights.size());
    for (int light = 0; light < lights; ++light)
        request.stages.push_back({"visibility", light});
    const auto frame = session.render(slot, viewOf(*session.snapshot(), size), request);
    Shown shown{picture::PictureEncoder().encode(slot.target.color, session.snapshot()->exposure), {}};
    for (int light = 0; light < lights; ++light)
        shown.visibility.push_back(picture::readVisibility(picture::findStage(frame, {"visibility", light})).greyAlpha);
    return shown;
}

TEST_F(RayStructuresTest, SameBytesOfEveryBuiltInScene) {
    const std::filesystem::path root = std::filesystem::path(SHADOWLAB_SOURCE_DIR) / "assets";
    int scenes = 0;
    for (const std::string& name : scene::builtInScenes(root)) {
        const auto snapshot = scene::loadScene(name, {.assetsRoot = root, .allowed = {}, .limits = {}});
        const double triangles = static_cast<double>(trace::worldTriangles(*snapshot).triangles.size());
        // Where every ray tries every triangle a small picture must do.
        const ivec2 size(96, 72), small(24, 18);
        picture::Session session(snapshot);
        picture::Slot slot = picture::Session::makeSlot("ray-traced");
        const Shown expected = show(session, slot, size), expectedSmall = show(session, slot, small);
        for (std::size_t i = 0; i < std::size(kExact); ++i) {
            const bool isSlow = triangles > 5000 && i < kTrees;
            choose(slot, kExact[i]);
            EXPECT_TRUE(show(session, slot, isSlow ? small : size) == (isSlow ? expectedSmall : expected))
                << name << ", " << kExact[i];
        }
        ++scenes;
    }
    EXPECT_GE(scenes, 11);
}

// In float: where it matters, at edges, a pixel may differ.
TEST_F(RayStructuresTest, EmbreeDiffersAtEdgesOnly) {
    const auto snapshot = testing::snapshot(testing::simpleScene());
    picture::Session session(snapshot);
    picture::Slot slot = picture::Session::makeSlot("ray-traced");
    const Shown expected = show(session, slot, {320, 240});
    choose(slot, "embree");
    const Shown found = show(session, slot, {320, 240});
    long different = 0;
    for (std::size_t i = 0; i < expected.visibility[0].size(); i += 2)
        different += expected.visibility[0][i] != found.visibility[0][i];
    std::cout << different << " of " << expected.visibility[0].size() / 2 << " pixels differ\n";
    EXPECT_LT(different, 40);
}

TEST_F(RayStructuresTest, SwitchedLiveAndMovedTheyAreRight) {
    picture::Session session(testing::snapshot(testing::simpleScene()));
    picture::Slot slot = picture::Session::makeSlot("ray-traced");
    const Shown before = show(session, slot, {96, 72});
    choose(slot, "grid");
    EXPECT_TRUE(show(session, slot, {96, 72}) == before);
    scene::Scene scene = *session.snapshot();
    scene.objects[1].worldFromObject = testing::translation({0.4, 0.3, 0.2}) * scene.objects[1].worldFromObject;
    scene.revisions.transforms = scene.revisions.geometry + 1000;
    session.setScene(testing::snapshot(scene));
    const Shown byGrid = show(session, slot, {96, 72});
    EXPECT_FALSE(byGrid == before);
    for (const char* structure : {"sphere-tree", "bvh", "grid"}) {
        choose(slot, structure);
        EXPECT_TRUE(show(session, slot, {96, 72}) == byGrid) << structure;
    }
}

TEST_F(RayStructuresTest, WithHolesAndReceiversFromAnIdBuffer) {
    const std::filesystem::path root = std::filesystem::path(SHADOWLAB_SOURCE_DIR) / "assets";
    picture::Session session(scene::loadScene("lattice", {.assetsRoot = root, .allowed = {}, .limits = {}}));
    picture::Slot slot = picture::Session::makeSlot("ray-traced");
    params::setFromText(params::find(slot.params, "receivers", "ray-traced"), "id-buffer", "ray-traced");
    const Shown expected = show(session, slot, {160, 120});
    for (const char* structure : {"groups", "sphere-tree", "grid"}) {
        choose(slot, structure);
        EXPECT_TRUE(show(session, slot, {160, 120}) == expected) << structure;
    }
}

TEST(StructureCacheTest, AreBuiltOnceAndInSlices) {
    const auto geometryOf = [](const scene::Scene& scene) {
        trace::SceneTracer tracer;
        tracer.advance(testing::snapshot(scene), Deadline::max());
        return tracer.geometry();
    };
    const auto geometry = geometryOf(testing::simpleScene());
    ray_tracing::StructureCache structures;
    using enum trace::Structure;
    int slices = 1;
    while (!structures.prepare(geometry, sphereTree, Deadline::min()).converged)
        ++slices;
    EXPECT_GT(slices, 3);
    const trace::Engine* const tree = &structures.engine();
    EXPECT_TRUE(structures.prepare(geometry, grid, Deadline::max()).converged);
    EXPECT_NE(&structures.engine(), tree);
    EXPECT_EQ(structures.chosen(), grid);
    EXPECT_TRUE(structures.prepare(geometry, sphereTree, Deadline::min()).converged); // it is still there
    EXPECT_EQ(&structures.engine(), tree);
    const bool hasEmbree = trace::makeEmbreeEngine({}) != nullptr;
    EXPECT_TRUE(structures.prepare(geometry, embree, Deadline::max()).converged);
    EXPECT_EQ(structures.chosen(), hasEmbree ? embree : bvh);
    scene::Scene other = testing::simpleScene();
    other.revisions.geometry += 1000;
    EXPECT_FALSE(structures.prepare(geometryOf(other), sphereTree, Deadline::min()).converged);
}

std::vector<vec4> stageOf(picture::Session& session, picture::Slot& slot, const char* id, ivec2 size,
                          Display* display = nullptr) {
    FrameRequest request;
    const StageKey key{id, kNoLight};
    request.stages = {key};
    const auto frame = session.render(slot, viewOf(*session.snapshot(), size), request);
    const Stage& stage = picture::findStage(frame, key);
    if (display) *display = stage.display;
    return gl::readRows<vec4>(stage.texture, GL_FLOAT, {0, 0}, size);
}

TEST_F(RayStructuresTest, StageCountsWhatRaysTry) {
    const ivec2 size(64, 48);
    picture::Session session(testing::snapshot(testing::simpleScene()));
    picture::Slot slot = picture::Session::makeSlot("ray-traced");
    const auto triangles = static_cast<float>(trace::worldTriangles(*session.snapshot()).triangles.size());
    std::map<std::string, double> sums;
    for (const char* structure : kExact) {
        choose(slot, structure);
        Display display;
        for (const vec4& texel : stageOf(session, slot, "intersection-tests", size, &display)) {
            EXPECT_EQ(texel.g, 1.0f);
            sums[structure] += texel.r;
            // The eye ray tries all of them; a shadow ray stops at the first that is hit.
            const bool isWhole = texel.r >= triangles && texel.r <= 2 * triangles;
            EXPECT_TRUE(isWhole || std::string_view(structure) != "none");
        }
        EXPECT_EQ(display.unit, "tests");
        EXPECT_GE(display.maximum, 1);
        std::cout << structure << ": " << sums[structure] / (size.x * size.y) << " tests per pixel\n";
    }
    for (const char* structure : {"object-spheres", "object-boxes", "groups"})
        EXPECT_LT(sums[structure], sums["none"] / 10) << structure;
    EXPECT_LT(sums["sphere-tree"], sums["object-spheres"]);
    EXPECT_LT(sums["bvh"], sums["sphere-tree"] / 3);
    EXPECT_LT(sums["grid"], sums["sphere-tree"] / 3);
}

TEST(ProbeOfStructuresTest, SaysWhatRaysTry) {
    const auto snapshot = testing::snapshot(testing::simpleScene());
    picture::Slot slot = picture::Session::makeSlot("ray-traced");
    std::map<std::string, long> tried;
    for (const char* structure : {"none", "object-boxes", "bvh", "grid"}) {
        choose(slot, structure);
        const Probe probe = slot.technique->probe(snapshot, viewOf(*snapshot, {64, 48}), {32, 30}, 0);
        ASSERT_FALSE(probe.tree.empty());
        const auto tests = std::ranges::find(probe.facts, "eye ray and shadow rays try", &Probe::Fact::label);
        ASSERT_LE(2, probe.facts.end() - tests);
        tried[structure] = std::stol(tests->value) + std::stol(tests[1].value);
    }
    EXPECT_GT(tried["none"], 3000);
    EXPECT_GT(tried["bvh"], 0);
    EXPECT_LT(tried["bvh"], tried["none"] / 10);
    EXPECT_LT(tried["grid"], tried["none"] / 10);
}

TEST_F(RayStructuresTest, StageShowsTheStructure) {
    const ivec2 size(320, 240);
    picture::Session session(testing::snapshot(testing::simpleScene()));
    picture::Slot slot = picture::Session::makeSlot("ray-traced");
    for (const char* structure : kExact) {
        choose(slot, structure);
        Display display;
        long colored = 0;
        for (const vec4& texel : stageOf(session, slot, "structure", size, &display))
            colored += std::abs(texel.r - texel.g) + std::abs(texel.g - texel.b) > 0.05f;
        ASSERT_FALSE(display.key.empty());
        std::cout << structure << ": " << colored << " pixels of lines, " << display.key.size() << " colours\n";
        if (std::string_view(structure) == "none") {
            EXPECT_EQ(colored, 0);
            continue;
        }
        EXPECT_GT(colored, 500) << structure;
        EXPECT_LT(colored, size.x * size.y / 2) << structure; // the picture is still to be seen
        bool named = false;
        for (const SceneShape& shape : slot.technique->shapes(session.snapshot(), viewOf(*session.snapshot(), size), 0))
            named |= shape.label == display.key[0].label && !shape.pointsWorld.empty();
        EXPECT_EQ(named, std::string_view(structure) != "bvh") << structure;
    }
}

} // namespace
} // namespace shadowlab
