// The pixels that repair marks, compared with a direct implementation of the rule; and that it goes on to the neighbours of
// a wrong pixel.
// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/repair/repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "techniques/foundation/trace/judge/exact_visibility.h"
#include "tests/support/scenes.h"

namespace shadowlab::shadow_volume {
namespace {

using testing::snapshot;
using trace::Visibility;

CountedPart emptyPart(ivec2 pictureSize, ivec2 corner, ivec2 size) {
    const auto pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    return {.pictureSize = pictureSize, .corner = corner, .size = size, .words = std::vector<std::uint32_t>(pixels, 0x800000u << 8)};
}

PixelMask nothing(const CountedPart& part) { return PixelMask(part.words.size(), 0); }

void setCounted(CountedPart& part, std::size_t index, bool counted) {
    part.words[index] = (part.words[index] & ~0xffu) | (counted ? 3u : 0u);
}
void setDepth(CountedPart& part, std::size_t index, double depth) {
    part.words[index] = (part.words[index] & 0xffu) | static_cast<std::uint32_t>(std::lround(depth * 0xffffff)) << 8;
}

/// The sentence in repair.h, word by word.
bool differs(const CountedPart& part, ivec2 pixel) {
    if (!part.hasSurface(part.index(pixel))) return false;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            const ivec2 other = pixel + ivec2(dx, dy), inPicture = part.corner + other;
            if (part.holds(other)) {
                if (part.isCounted(part.index(other)) != part.isCounted(part.index(pixel))) return true;
            } else if (!part.isAll && inPicture.x >= 0 && inPicture.y >= 0 && inPicture.x < part.pictureSize.x &&
                       inPicture.y < part.pictureSize.y) {
                return true; // drawn by somebody else
            }
        }
    return false;
}

TEST(Repair, PixelsThatDifferAreFoundAndNoOthers) {
    std::mt19937 random(1);
    int marked = 0, looked = 0;
    for (const ivec2 size : {ivec2(1, 1), ivec2(1, 9), ivec2(9, 1), ivec2(17, 12), ivec2(40, 23)})
        for (const ivec2 corner : {ivec2(0), ivec2(3, 0), ivec2(0, 2)})
            for (const ivec2 beyond : {ivec2(0), ivec2(5, 0), ivec2(0, 1)})
                for (const double dark : {0.0, 0.03, 0.5, 1.0}) {
                    CountedPart part = emptyPart(corner + size + beyond, corner, size);
                    part.isAll = std::bernoulli_distribution(0.3)(random);
                    for (std::size_t i = 0; i < part.words.size(); ++i) {
                        setCounted(part, i, std::bernoulli_distribution(dark)(random));
                        setDepth(part, i, std::bernoulli_distribution(0.1)(random) ? 1 : 0.5);
                    }
                    PixelMask mask = nothing(part);
                    markDiffering(part, mask);
                    for (int y = 0; y < size.y; ++y)
                        for (int x = 0; x < size.x; ++x) {
                            ASSERT_EQ(mask[part.index({x, y})] != 0, differs(part, {x, y})) << x << " " << y;
                            marked += mask[part.index({x, y})];
                            ++looked;
                        }
                }
    EXPECT_GT(marked, 2000);
    EXPECT_LT(marked, looked - 2000);
}

/// Random edges before, behind and beside the eye, some of them on both sides of the near plane.
struct Edges {
    static constexpr int kCount = 60;
    scene::Mesh mesh;
    std::vector<SilhouetteEdge> edges;
    dmat4 clipFromMesh;
    Edges() {
        std::mt19937 random(2);
        std::uniform_real_distribution<float> place(-4, 4);
        for (std::uint32_t i = 0; i < kCount; ++i) {
            mesh.positionsMesh.emplace_back(place(random), place(random), place(random));
            mesh.positionsMesh.emplace_back(place(random), place(random), place(random));
            edges.push_back({2 * i, 2 * i + 1});
        }
        scene::Camera camera;
        camera.positionWorld = {0, 0, 3};
        clipFromMesh = scene::clipFromView(camera, 48.0 / 36.0) * scene::viewFromWorld(camera);
    }
    /// Calls visit(pixel of the part, depth) for many points of all edges that lie in the part.
    template <typename Visit>
    void walk(const CountedPart& part, const Visit& visit) const {
        constexpr int kSteps = 4000;
        for (const SilhouetteEdge& edge : edges)
            for (int i = 0; i <= kSteps; ++i) {
                const dvec3 point = glm::mix(dvec3(mesh.positionsMesh[edge.a]), dvec3(mesh.positionsMesh[edge.b]),
                                             static_cast<double>(i) / kSteps);
                const dvec4 clip = clipFromMesh * dvec4(point, 1.0);
                if (clip.z < -clip.w) continue;
                const dvec2 picture = dvec2(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w);
                const ivec2 pixel = ivec2(glm::floor(picture * dvec2(part.pictureSize))) - part.corner;
                if (part.holds(pixel)) visit(pixel, 0.5 + 0.5 * clip.z / clip.w);
            }
    }
};

TEST(Repair, EveryPixelThatAnEdgeTouchesIsMarkedAndFewOthers) {
    const Edges edges;
    for (const auto& [corner, size] : {std::pair(ivec2(0), ivec2(48, 36)), std::pair(ivec2(11, 7), ivec2(20, 13))}) {
        CountedPart part = emptyPart({48, 36}, corner, size);
        for (std::size_t i = 0; i < part.words.size(); ++i)
            setDepth(part, i, 0.99999); // behind all edges
        int wrong = 0, touched = 0;
        for (std::size_t e = 0; e < edges.edges.size(); ++e) {
            Edges one = edges;
            one.edges = {edges.edges[e]};
            PixelMask mask = nothing(part), walked = nothing(part);
            markEdges(part, one.mesh, one.edges, one.clipFromMesh, mask);
            one.walk(part, [&](ivec2 pixel, double) { walked[part.index(pixel)] = 1; });
            for (std::size_t i = 0; i < mask.size(); ++i) {
                EXPECT_GE(mask[i], walked[i]) << e << " " << i;
                wrong += mask[i] > walked[i]; // a corner that is cut by less than a step
                touched += walked[i];
            }
        }
        EXPECT_GT(touched, 100);
        EXPECT_LT(wrong, touched / 50);
    }
}

TEST(Repair, EdgesBehindWhatIsSeenAreLeftOut) {
    const Edges edges;
    CountedPart part = emptyPart({48, 36}, {0, 0}, {48, 36});
    for (int y = 0; y < 36; ++y)
        for (int x = 0; x < 48; ++x)
            setDepth(part, part.index({x, y}), x < 24 ? 0.97 : 1); // a wall at 3.3 m, and nothing
    PixelMask mask = nothing(part);
    markEdges(part, edges.mesh, edges.edges, edges.clipFromMesh, mask);
    PixelMask before = nothing(part), any = nothing(part);
    edges.walk(part, [&](ivec2 pixel, double depth) {
        any[part.index(pixel)] = 1;
        if (depth <= 0.97 && pixel.x < 24) before[part.index(pixel)] = 1;
    });
    int left = 0, kept = 0;
    for (int y = 0; y < 36; ++y)
        for (int x = 0; x < 48; ++x) {
            const std::size_t i = part.index({x, y});
            EXPECT_GE(mask[i], before[i]);
            if (x >= 24) {
                EXPECT_EQ(mask[i], 0) << "no surface";
            }
            kept += mask[i];
            left += x < 23 && any[i] && !mask[i];
        }
    EXPECT_GT(kept, 50);
    EXPECT_GT(left, 50);
}

class Decided : public ::testing::Test {
protected:
    static constexpr ivec2 kSize{80, 60};
    Decided() : scene_(snapshot(testing::simpleScene())), judge_(scene_), part_(emptyPart(kSize, {0, 0}, kSize)) {
        tracer_.advance(scene_, std::chrono::steady_clock::time_point::max());
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x)
                truth_[part_.index({x, y})] = judge_.at(scene_->camera, dvec2(x, y) + 0.5, kSize, 0);
        for (std::size_t i = 0; i < truth_.size(); ++i) {
            setCounted(part_, i, truth_[i] == Visibility::shadowed);
            setDepth(part_, i, truth_[i] == Visibility::noSurface ? 1 : 0.5);
        }
    }
    [[nodiscard]] Repair decided(PixelMask mask) const {
        trace::PixelRays rays;
        return decide(part_, mask, tracer_, scene_->camera, 0, rays);
    }
    /// 1 where the bit has to be turned over.
    static PixelMask flipsOf(const Repair& repair, const CountedPart& part) {
        PixelMask flips = nothing(part);
        for (const ivec2& pixel : repair.flips)
            ++flips[part.index(pixel - part.corner)];
        return flips;
    }
    /// The bits with those turned over that repair wants turned over, where they matter.
    [[nodiscard]] int wrongAfter(const Repair& repair) const {
        int wrong = 0;
        const PixelMask flips = flipsOf(repair, part_);
        for (std::size_t i = 0; i < truth_.size(); ++i)
            if (truth_[i] == Visibility::lit || truth_[i] == Visibility::shadowed)
                wrong += (part_.isCounted(i) != (flips[i] != 0)) != (truth_[i] == Visibility::shadowed);
        return wrong;
    }

    scene::Snapshot scene_;
    trace::ExactVisibility judge_;
    trace::SceneTracer tracer_;
    CountedPart part_;
    std::vector<Visibility> truth_ = std::vector<Visibility>(part_.words.size()); ///< in the order of the part
};

TEST_F(Decided, WhatIsRightStays) {
    const Repair repair = decided(PixelMask(truth_.size(), 1));
    EXPECT_EQ(repair.lookedAt.size(), truth_.size());
    EXPECT_EQ(repair.changed.size(), 0u);
    EXPECT_EQ(wrongAfter(repair), 0);
    EXPECT_GT(std::ranges::count(truth_, Visibility::lit), 500);
    EXPECT_GT(std::ranges::count(truth_, Visibility::shadowed), 50);
    // Those turned away are dark now, whatever was counted there.
    const PixelMask flips = flipsOf(repair, part_);
    for (std::size_t i = 0; i < truth_.size(); ++i)
        if (truth_[i] == Visibility::turnedAway) {
            EXPECT_EQ(flips[i], 1);
        }
}

TEST_F(Decided, AFaultIsFollowedAsFarAsItReaches) {
    // A block in which every bit is wrong, of which one pixel in the middle of the floor is doubted.
    const ivec2 lower(30, 40), upper(50, 55);
    int turned = 0;
    for (int y = lower.y; y < upper.y; ++y)
        for (int x = lower.x; x < upper.x; ++x) {
            const std::size_t i = part_.index({x, y});
            setCounted(part_, i, !part_.isCounted(i));
            turned += truth_[i] == Visibility::lit || truth_[i] == Visibility::shadowed;
        }
    PixelMask mask = nothing(part_);
    mask[part_.index({40, 48})] = 1;
    const Repair repair = decided(mask);
    EXPECT_EQ(turned, 300);
    EXPECT_EQ(repair.changed.size(), 300u);
    EXPECT_EQ(repair.lookedAt.size(), 22u * 17u); // and one more around it, where it ends
    EXPECT_EQ(wrongAfter(repair), 0);
}

TEST_F(Decided, PixelsBesideABlockOfRaysAndAloneGetOneAnswer) {
    // The same picture in odd parts, so that other pixels share a block: same bits.
    for (std::size_t i = 0; i < part_.words.size(); ++i)
        setCounted(part_, i, !part_.isCounted(i));
    const Repair all = decided(PixelMask(truth_.size(), 1));
    EXPECT_EQ(wrongAfter(all), 0);
    const CountedPart whole = part_;
    for (const int keep : {1, 3, 13}) {
        std::size_t asked = 0;
        CountedPart part = emptyPart(kSize, {5, 3}, {70, 50});
        for (int y = 0; y < part.size.y; ++y)
            for (int x = 0; x < part.size.x; ++x)
                setCounted(part, part.index({x, y}), whole.isCounted(whole.index(part.corner + ivec2(x, y))));
        for (std::size_t i = 0; i < part.words.size(); ++i)
            setDepth(part, i, 1); // nothing is followed
        PixelMask marked = nothing(part);
        for (std::size_t i = 0; i < marked.size(); i += static_cast<std::size_t>(keep)) {
            marked[i] = 1;
            ++asked;
        }
        trace::PixelRays rays;
        const Repair repair = decide(part, marked, tracer_, scene_->camera, 0, rays);
        EXPECT_EQ(repair.lookedAt.size(), asked);
        const PixelMask flips = flipsOf(repair, part), allFlips = flipsOf(all, whole);
        for (int y = 0; y < part.size.y; ++y)
            for (int x = 0; x < part.size.x; ++x)
                if (marked[part.index({x, y})]) {
                    EXPECT_EQ(flips[part.index({x, y})], allFlips[whole.index(part.corner + ivec2(x, y))]);
                }
    }
}

} // namespace
} // namespace shadowlab::shadow_volume
