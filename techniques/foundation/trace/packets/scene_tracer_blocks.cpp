// The answers of a SceneTracer for a block of pixels at a time: made ready here, traced by a block kernel, and what that
// leaves open decided here as for a single ray.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "techniques/foundation/scene/query/shading.h"
#include "techniques/foundation/trace/bvh/bvh_traverse.h"
#include "techniques/foundation/trace/scene_tracer.h"

namespace shadowlab::trace {

namespace {

// Two groups and two more of each are what silhouettes want; parting again costs more than it saves.
constexpr int kMostParted = 3;

constexpr std::uint64_t bit(std::size_t ray) { return std::uint64_t{1} << ray; }

template <typename Work>
void forEachBit(std::uint64_t bits, const Work& work) {
    for (; bits != 0; bits &= bits - 1)
        work(static_cast<std::size_t>(std::countr_zero(bits)));
}

int mainAxis(const dvec3& d) {
    const dvec3 m = glm::abs(d);
    return m.x > m.y ? (m.x > m.z ? 0 : 2) : (m.y > m.z ? 1 : 2);
}

void setAxes(BlockRays& block, const dvec3& direction) {
    const int main = mainAxis(direction);
    block.axes[0] = (main + 1) % 3;
    block.axes[1] = (main + 2) % 3;
    block.axes[2] = main;
    block.sign = direction[main] < 0 ? -1 : 1;
}

void setOrigin(BlockRays& block, const dvec3& originCentred) {
    for (int axis = 0; axis < 3; ++axis)
        block.origin[axis] = originCentred[axis];
}

dvec3 vectorOf(const BlockVectors& vectors, std::size_t i) {
    return {vectors.axis[0][i], vectors.axis[1][i], vectors.axis[2][i]};
}

std::uint64_t raysInDoubt(const BlockAnswers& answers) {
    std::uint64_t rays = 0;
    for (int i = 0; i < answers.doubtCount; ++i)
        rays |= bit(answers.doubts[i].ray);
    return rays;
}

/// The corners of all triangles, as the kernels read them.
const double* cornersOf(const Bvh& bvh) {
    static_assert(sizeof(Triangle) == 9 * sizeof(double));
    return &bvh.triangles[0].a.x;
}

/// Predicts whether the next block is worth tracing as a block, or would be given up and is better traced ray by ray.
/// Neighbours are alike: after one block that was given up the next is skipped, after two in a row three, and so on up to
/// fifteen. Each thread has its own state; the answers are the same either way, only the time differs.
class Patience {
public:
    [[nodiscard]] bool isWorthTrying() {
        if (leftOut_ == 0) return true;
        --leftOut_;
        return false;
    }
    void tell(bool isGivenUp) {
        failures_ = isGivenUp ? std::min(failures_ + 1, kMostDoublings) : 0;
        leftOut_ = (1 << failures_) - 1;
    }

private:
    static constexpr int kMostDoublings = 4;
    int failures_ = 0, leftOut_ = 0;
};
thread_local Patience patienceOfEyeRays, patienceOfShadowRays;

BlockTreeView viewOf(const Bvh& bvh, const Holes& holes) {
    return {bvh.nodes.data(), bvh.leaves.data(), bvh.largest, holes.flags()};
}

} // namespace

void SceneTracer::eyePoints(const EyeRays& rays, ivec2 corner, ivec2 blockSize, dvec2 within,
                            std::span<SurfacePoint> points) const {
    eyePointsOn({}, rays, corner, blockSize, within, points);
}

void SceneTracer::eyePointsOn(std::span<const std::uint32_t> primitives, const EyeRays& rays, ivec2 corner,
                              ivec2 blockSize, dvec2 within, std::span<SurfacePoint> points) const {
    const bool othersMayBeSeen = rays.eyeIsWithin() || coincident_->mayAnyShowAnother();
    for (int y = 0; y < blockSize.y; y += kBlock)
        for (int x = 0; x < blockSize.x; x += kBlock) {
            const ivec2 size = glm::min(ivec2(kBlock), blockSize - ivec2(x, y));
            const auto first = static_cast<std::size_t>(y * blockSize.x + x);
            eyeBlock(rays, corner + ivec2(x, y), size, within, primitives.empty() ? nullptr : &primitives[first],
                     &points[first], blockSize.x);
            if (!othersMayBeSeen) continue;
            // Where faces coincide, the nearest is not always what is seen.
            for (int row = 0; row < size.y; ++row)
                for (int column = 0; column < size.x; ++column) {
                    SurfacePoint& point = points[first + static_cast<std::size_t>(row * blockSize.x + column)];
                    if (point && mayShowAnother(point, rays.eyeIsWithin()))
                        point = eyePoint(rays, dvec2(corner + ivec2(x + column, y + row)) + within);
                }
        }
}

void SceneTracer::eyeBlock(const EyeRays& rays, ivec2 corner, ivec2 blockSize, dvec2 within,
                           const std::uint32_t* expected, SurfacePoint* points, int stride) const {
    const auto placeOf = [&](std::size_t i) { return ivec2(int(i) % kBlock, int(i) / kBlock); };
    const auto indexOf = [&](std::size_t i) { return placeOf(i).y * stride + placeOf(i).x; };
    const auto alone = [&](std::size_t i) { points[indexOf(i)] = eyePoint(rays, dvec2(corner + placeOf(i)) + within); };
    std::uint64_t there = 0;
    for (int y = 0; y < blockSize.y; ++y)
        there |= (bit(static_cast<std::size_t>(blockSize.x)) - 1) << (y * kBlock);

    BlockRays block;
    BlockVectors directions;
    double depth[2];
    setOrigin(block, rays.eyeCentred());
    block.parallel = 0;
    block.largest = 0;
    const bool usable =
        !bvh().nodes.empty() && std::isfinite(glm::dot(rays.eyeCentred(), dvec3(1))) && rays.nearest() > 0;
    if (!usable || !kernels_->aimFan(rays.fan(corner, within), block, directions, depth)) {
        forEachBit(there, alone);
        return;
    }
    // Of the rays in `hit`, what the kernel finds on the triangles in `ends`; returns those that have ended there.
    BlockPoints ends;
    const auto land = [&](std::uint64_t hit) {
        block.asked = hit;
        kernels_->land(cornersOf(bvh()), block, directions, rays.nearest(), ends);
        forEachBit(hit & ~ends.open, [&](std::size_t i) {
            points[indexOf(i)] = {
                ends.primitives[i], (ends.eyeOnFront & bit(i)) != 0, {ends.weights[0][i], ends.weights[1][i]}};
        });
        return hit & ~ends.open;
    };
    std::uint64_t left = there;
    if (expected) {
        std::uint64_t known = 0;
        for (std::size_t i = 0; i < kBlockRays; ++i) {
            const std::uint32_t primitive = there & bit(i) ? expected[indexOf(i)] : kNoPrimitive;
            known |= primitive < bvh().triangles.size() && !holes_.in(primitive) ? bit(i) : 0;
            ends.primitives[i] = known & bit(i) ? primitive : 0;
        }
        left &= ~land(known);
        if (!left) return;
    }
    if (engine_ || !patienceOfEyeRays.isWorthTrying()) {
        forEachBit(left, alone);
        return;
    }

    block.asked = left;
    // The value at the near plane, which is one depth along the camera's axis; a bit more than float's rounding.
    block.ceiling[0] = static_cast<float>(1 / (rays.nearest() * depth[1])) * (1 - 1e-6f);
    block.ceiling[1] = static_cast<float>(1 / (rays.nearest() * depth[0])) * (1 + 1e-6f);
    block.nearest = 0;
    block.farthest = std::numeric_limits<float>::infinity();
    BlockAnswers answers;
    kernels_->nearest(viewOf(bvh(), holes_), block, answers);
    patienceOfEyeRays.tell(answers.givenUp == block.asked);

    std::uint64_t hit = 0;
    for (std::size_t i = 0; i < kBlockRays; ++i) {
        hit |= answers.primitives[i] != kNoPrimitive ? bit(i) : 0;
        ends.primitives[i] = hit & bit(i) ? answers.primitives[i] : 0;
    }
    const std::uint64_t doubtful = raysInDoubt(answers), certain = left & ~doubtful & ~answers.givenUp;
    forEachBit(certain & ~hit, [&](std::size_t i) { points[indexOf(i)] = {}; });
    const std::uint64_t ended = hit & certain ? land(hit & certain) : 0;
    forEachBit((certain & hit & ~ended) | answers.givenUp, alone);
    forEachBit(doubtful & ~answers.givenUp, [&](std::size_t i) {
        const ShearedRay sheared(rays.through(dvec2(corner + placeOf(i)) + within));
        RayHit best;
        double farthest = sheared.farthest;
        const auto consider = [&](std::uint32_t primitive) {
            const auto found = intersect(sheared, bvh().triangles[primitive], farthest);
            if (!found || !(found->reach < farthest || (best && primitive < best.primitive))) return;
            if (holes_(primitive, found->barycentric)) return;
            farthest = found->reach;
            best = {farthest / sheared.reachPerT, primitive, found->barycentric};
        };
        if (hit & bit(i)) consider(answers.primitives[i]);
        for (int d = 0; d < answers.doubtCount; ++d)
            if (answers.doubts[d].ray == i) consider(answers.doubts[d].primitive);
        points[indexOf(i)] = surfacePoint(rays, best);
    });
}

void SceneTracer::visibilities(std::span<const SurfacePoint> points, int light, std::span<Visibility> answers) const {
    for (std::size_t i = 0; i < points.size(); i += kBlockRays) {
        const std::size_t count = std::min<std::size_t>(kBlockRays, points.size() - i);
        shadowBlock(points.subspan(i, count), light, answers.subspan(i, count));
    }
}

void SceneTracer::shadowBlock(std::span<const SurfacePoint> points, int light, std::span<Visibility> answers) const {
    const scene::Light& source = snapshot_->light(light);
    const LightView& view = lights_[static_cast<std::size_t>(light)];
    const bool everywhere = scene::shinesEverywhere(source);
    std::uint64_t wanted = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SurfacePoint& point = points[i];
        answers[i] = Visibility::noSurface;
        if (!point) continue;
        const std::uint8_t gates = view.gates[point.primitive];
        const bool faces = (gates & (point.eyeOnFront ? facesFront : facesBack)) &&
                           (everywhere || scene::lightShinesTo(source, positionWorld(point)));
        answers[i] = faces ? Visibility::lit : Visibility::turnedAway;
        if (!faces || !(gates & receives)) continue;
        if (coincidentWith(point.primitive))
            answers[i] = visibility(point, light); // more than its own triangle is left out
        else
            wanted |= bit(i);
    }
    if (engine_ || (wanted && !patienceOfShadowRays.isWorthTrying()))
        forEachBit(wanted, [&](std::size_t i) { answers[i] = visibility(points[i], light); });
    else if (wanted)
        traceShadowRays(points, wanted, light, answers);
}

void SceneTracer::traceShadowRays(std::span<const SurfacePoint> points, std::uint64_t wanted, int light,
                                  std::span<Visibility> answers) const {
    const scene::Light& source = snapshot_->light(light);
    const std::vector<std::uint8_t>& blocks = lights_[static_cast<std::size_t>(light)].blocks;
    BlockPoints starts;
    for (std::size_t i = 0; i < kBlockRays; ++i) {
        const SurfacePoint& point = points[wanted & bit(i) ? i : static_cast<std::size_t>(std::countr_zero(wanted))];
        starts.primitives[i] = point.primitive;
        starts.weights[0][i] = point.weights.x;
        starts.weights[1][i] = point.weights.y;
    }
    BlockVectors positions, placed;
    kernels_->positions(cornersOf(bvh()), starts, positions);

    // Rays that do not go the same way, or end on different things, are better traced in groups.
    std::array<std::uint64_t, kBlockRays> groups;
    std::size_t waiting = 0;
    int parted = 0;
    groups[waiting++] = wanted;
    while (waiting > 0) {
        const std::uint64_t group = groups[--waiting];
        const auto first = static_cast<std::size_t>(std::countr_zero(group));
        BlockRays block;
        block.asked = group;
        aimTowardLight(source, vectorOf(positions, first), block);
        // What is not in the group stands where the one before it stands, so that no row is wider for it.
        for (std::size_t i = 0, from = first; i < kBlockRays; ++i) {
            from = group & bit(i) ? i : from;
            for (int axis = 0; axis < 3; ++axis)
                placed.axis[axis][i] = positions.axis[axis][from];
        }
        const double contact = block.parallel ? 2 * kContactPerMetre * (1 + 2.0 * bvh().largest) : 0;
        const std::uint64_t forward = kernels_->aimAtPoints(placed, contact, block) & group;
        const std::uint64_t apart = !forward               ? 0
                                    : forward != group     ? forward
                                    : parted < kMostParted ? kernels_->part(block) & group
                                                           : 0;
        if (apart && apart != group) {
            ++parted;
            groups[waiting++] = group & ~apart;
            groups[waiting++] = apart;
            continue;
        }
        BlockAnswers traced;
        traced.doubtCount = 0;
        traced.blocked = 0;
        traced.givenUp = group; // a point at the light itself has no direction toward it
        const BlockTreeView tree = viewOf(bvh(), holesForLight_);
        if (forward) kernels_->blocked(tree, block, blocks.data(), starts.primitives, traced);
        patienceOfShadowRays.tell(forward && traced.givenUp && (traced.givenUp | traced.blocked) == group);
        const std::uint64_t alone = traced.givenUp & ~traced.blocked;
        forEachBit(traced.blocked, [&](std::size_t i) { answers[i] = Visibility::shadowed; });
        forEachBit(alone, [&](std::size_t i) { answers[i] = visibility(points[i], light); });
        for (int d = 0; d < traced.doubtCount; ++d) {
            const auto [ray, primitive] = traced.doubts[d];
            if (alone & bit(ray) || answers[ray] == Visibility::shadowed) continue;
            const ShearedRay sheared(shadowRay(points[ray], light, ShadowStart::exact));
            const auto hit = intersect(sheared, bvh().triangles[primitive], sheared.farthest);
            if (hit && hit->reach < sheared.farthest && !holesForLight_(primitive, hit->barycentric))
                answers[ray] = Visibility::shadowed;
        }
    }
}

void SceneTracer::aimTowardLight(const scene::Light& source, const dvec3& firstCentred, BlockRays& block) const {
    if (source.type == scene::LightType::directional) {
        const dvec3 toward = -source.directionWorld;
        block.parallel = 1;
        setOrigin(block, firstCentred);
        setAxes(block, toward);
        const double depth = toward[block.axes[2]] * block.sign;
        block.shear[0] = toward[block.axes[0]] / depth;
        block.shear[1] = toward[block.axes[1]] / depth;
    } else {
        const dvec3 lightCentred = source.positionWorld - world().originWorld;
        block.parallel = 0;
        setOrigin(block, lightCentred);
        setAxes(block, firstCentred - lightCentred);
    }
}

} // namespace shadowlab::trace
