// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/structures/naive_intersection.h"

#include <array>

#include "techniques/foundation/trace/ray.h"
#include "techniques/foundation/trace/structures/ray_volumes.h"

namespace shadowlab::ray_tracing {

namespace {

class NaiveEngine final : public trace::Engine {
public:
    NaiveEngine(const trace::Bvh& bvh, float margin) : bvh_(bvh), margin_(margin) {}

    [[nodiscard]] trace::RayHit closest(const trace::Ray& ray, const trace::MayHit& mayHit) const override {
        return search(ray, mayHit, false, trace::CountNothing{});
    }
    [[nodiscard]] trace::RayHit closest(const trace::Ray& ray, const trace::MayHit& mayHit,
                                        trace::RayTests& tests) const override {
        return search(ray, mayHit, false, trace::CountTests{tests});
    }
    [[nodiscard]] std::uint32_t any(const trace::Ray& ray, const trace::MayHit& mayHit) const override {
        return search(ray, mayHit, true, trace::CountNothing{}).primitive;
    }
    [[nodiscard]] std::uint32_t any(const trace::Ray& ray, const trace::MayHit& mayHit,
                                    trace::RayTests& tests) const override {
        return search(ray, mayHit, true, trace::CountTests{tests}).primitive;
    }

private:
    /// Traverses the tree depth first, without ordering children: simple and slow. `anyHit`: the first hit that is found will do.
    template <typename Count>
    trace::RayHit search(const trace::Ray& ray, const trace::MayHit& mayHit, bool anyHit, Count count) const {
        trace::RayHit best;
        if (bvh_.nodes.empty() || !trace::isUsable(ray)) return best;
        const trace::ShearedRay sheared(ray);
        const trace::VolumeRay volumes(sheared);
        double farthest = ray.farthest;
        std::array<trace::BvhChild, (trace::kBvhWidth - 1) * trace::Bvh::kMostDepth + trace::kBvhWidth> stack;
        std::size_t size = 0;
        stack[size++] = trace::BvhChild::node(0);
        while (size > 0 && !(anyHit && best)) {
            const trace::BvhChild next = stack[--size];
            if (next.isLeaf()) {
                tryLeaf(bvh_.leaves[next.index()], ray, mayHit, farthest, best, count);
                continue;
            }
            const trace::BvhNode& node = bvh_.nodes[next.index()];
            for (int i = 0; i < node.count; ++i) {
                trace::Box box;
                for (int axis = 0; axis < 3; ++axis) {
                    box.lowerCentred[axis] = node.planes[axis][0][i];
                    box.upperCentred[axis] = node.planes[axis][1][i];
                }
                count.volumes(1);
                if (volumes.enter(box, farthest * sheared.reachPerT * kSlack) != trace::kNowhere)
                    stack[size++] = trace::BvhChild(node.children[i]);
            }
        }
        return best;
    }

    template <typename Count>
    void tryLeaf(const trace::BvhLeaf& leaf, const trace::Ray& ray, const trace::MayHit& mayHit, double& farthest,
                 trace::RayHit& best, Count& count) const {
        count.step();
        for (int i = 0; i < leaf.count; ++i) {
            const std::uint32_t primitive = leaf.primitives[i];
            if (!mayHit(primitive)) continue;
            count.triangles(1);
            const auto hit = naiveHit(ray, bvh_.triangles[primitive], margin_);
            if (!hit || !(hit->t > ray.nearest && hit->t < farthest)) continue;
            if (mayHit.inHole(primitive, hit->barycentric)) continue;
            best = {hit->t, primitive, hit->barycentric};
            farthest = hit->t;
        }
    }

    // The relative error of a distance in float is smaller, except for edge-on triangles.
    static constexpr double kSlack = 1 + 1e-5;
    const trace::Bvh& bvh_;
    float margin_;
};

} // namespace

// [anchor: naive-hit]
std::optional<NaiveHit> naiveHit(const trace::Ray& ray, const trace::Triangle& triangle, float margin) {
    const vec3 originCentred(ray.originCentred), directionCentred(ray.directionCentred), a(triangle.a);
    const vec3 toB = vec3(triangle.b) - a, toC = vec3(triangle.c) - a;
    const vec3 p = glm::cross(directionCentred, toC);
    const float determinant = glm::dot(toB, p);
    if (determinant == 0.0f) return std::nullopt; // edge-on
    const vec3 fromA = originCentred - a, q = glm::cross(fromA, toB);
    const float ofB = glm::dot(fromA, p) / determinant, ofC = glm::dot(directionCentred, q) / determinant;
    const float ofA = 1.0f - ofB - ofC;
    if (!(ofA > margin && ofB > margin && ofC > margin)) return std::nullopt;
    return NaiveHit{glm::dot(toC, q) / determinant, {ofA, ofB, ofC}};
}

std::unique_ptr<trace::Engine> makeNaiveEngine(const trace::Bvh& bvh, float margin) {
    return std::make_unique<NaiveEngine>(bvh, margin);
}

} // namespace shadowlab::ray_tracing
