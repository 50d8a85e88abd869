// Tracers of one scene share what is built, those of different ones do not, and unused geometry is freed.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/foundation/trace/scene_tracer.h"
#include "tests/support/scenes.h"

namespace shadowlab::trace {
namespace {

using namespace shadowlab::testing;

constexpr auto kForever = std::chrono::steady_clock::time_point::max();

TEST(TracedGeometry, IsBuiltOnceForAllTracersOfAScene) {
    const scene::Snapshot scene = snapshot(simpleScene());
    SceneTracer first, second;
    ASSERT_TRUE(first.advance(scene, kForever));
    // No time at all: only what is there already can be ready.
    ASSERT_TRUE(second.advance(scene, std::chrono::steady_clock::time_point::min()));
    EXPECT_EQ(&first.world(), &second.world());
    EXPECT_EQ(&first.bvh(), &second.bvh());
    EXPECT_GT(first.bvh().triangles.size(), 10u);
}

TEST(TracedGeometry, OutlivesWhoBuiltItAndNobodyElse) {
    const scene::Snapshot scene = snapshot(simpleScene());
    SceneTracer second;
    {
        SceneTracer first;
        ASSERT_TRUE(first.advance(scene, kForever));
        ASSERT_TRUE(second.advance(scene, kForever));
    }
    EXPECT_NE(sharedGeometry(*scene), nullptr);
    EXPECT_GT(second.bvh().triangles.size(), 10u);
    second = SceneTracer();
    EXPECT_EQ(sharedGeometry(*scene), nullptr);
}

TEST(TracedGeometry, OfAMovedObjectIsAnother) {
    const scene::Snapshot before = snapshot(simpleScene());
    scene::Scene moved = *before;
    moved.objects.back().worldFromObject[3].x += 0.5;
    moved.revisions.transforms = scene::newRevision();
    const scene::Snapshot after = snapshot(moved);
    SceneTracer still, follows;
    ASSERT_TRUE(still.advance(before, kForever));
    ASSERT_TRUE(follows.advance(before, kForever));
    ASSERT_TRUE(follows.advance(after, kForever));
    EXPECT_NE(&still.world(), &follows.world());
    const std::size_t corner = still.world().firstOfObject.back();
    EXPECT_NE(still.world().triangles[corner].a.x, follows.world().triangles[corner].a.x);
    // And back to the first scene, whose geometry another tracer still holds, but which is not the last shared one.
    ASSERT_TRUE(follows.advance(before, kForever));
    EXPECT_EQ(still.world().triangles[corner].a, follows.world().triangles[corner].a);
}

} // namespace
} // namespace shadowlab::trace
