// The purpose of a ray, separate from the structure that finds triangles: the structure names candidates one after the
// other, and the query tests them.
//
//     NearestHit   keeps the nearest hit; of equally near ones the lowest, so that the order does not matter
//     AnyHit       stops at the first hit
//
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/trace/ray.h"
#include "techniques/foundation/trace/structures/engine.h"

namespace shadowlab::trace {

class RayQuery {
public:
    RayQuery(const Ray& ray, std::span<const Triangle> triangles, const MayHit& mayHit)
        : sheared(ray), triangles_(triangles), mayHit_(mayHit), farthest_(sheared.farthest) {}

    const ShearedRay sheared;

    /// Nothing beyond this is asked for any more, in units of reach. A little more than the nearest hit, because a
    /// computed reach is: wrong by less than a millionth of itself, unless the triangle is seen within some 1e-8 of edge-on.
    [[nodiscard]] double farthest() const { return farthest_ * (1 + kReachSlack); }
    static constexpr double kReachSlack = 1e-6;

protected:
    std::span<const Triangle> triangles_;
    const MayHit& mayHit_;
    double farthest_;
};

class NearestHit : public RayQuery {
public:
    using RayQuery::RayQuery;

    void tryTriangle(std::uint32_t primitive) {
        const auto hit = intersect(sheared, triangles_[primitive], farthest_);
        if (!hit || !mayHit_(primitive)) return;
        if (!(hit->reach < farthest_ || (best_ && primitive < best_.primitive))) return;
        if (mayHit_.inHole(primitive, hit->barycentric)) return;
        farthest_ = hit->reach;
        best_ = {0, primitive, hit->barycentric};
    }
    [[nodiscard]] bool isAnswered() const { return false; } // something nearer may always come
    [[nodiscard]] RayHit answer() const {
        RayHit hit = best_;
        if (hit) hit.t = farthest_ / sheared.reachPerT;
        return hit;
    }

private:
    RayHit best_;
};

class AnyHit : public RayQuery {
public:
    using RayQuery::RayQuery;

    void tryTriangle(std::uint32_t primitive) {
        if (isAnswered() || !mayHit_(primitive)) return;
        const auto hit = intersect(sheared, triangles_[primitive], farthest_);
        if (hit && hit->reach < farthest_ && !mayHit_.inHole(primitive, hit->barycentric)) found_ = primitive;
    }
    [[nodiscard]] bool isAnswered() const { return found_ != kNoPrimitive; }
    [[nodiscard]] std::uint32_t answer() const { return found_; }

private:
    std::uint32_t found_ = kNoPrimitive;
};

/// An engine made of a function that names triangles: `void visit(const Ray&, Query&, Count) const`, for each kind of query
/// and of counting. `Walk` is the class that has it.
template <typename Walk>
class WalkingEngine : public Engine {
public:
    explicit WalkingEngine(const EngineInput& input) : input_(input) {}
    [[nodiscard]] RayHit closest(const Ray& ray, const MayHit& mayHit) const override {
        return ask<NearestHit, RayHit>(ray, mayHit, CountNothing{}, {});
    }
    [[nodiscard]] RayHit closest(const Ray& ray, const MayHit& mayHit, RayTests& tests) const override {
        return ask<NearestHit, RayHit>(ray, mayHit, CountTests{tests}, {});
    }
    [[nodiscard]] std::uint32_t any(const Ray& ray, const MayHit& mayHit) const override {
        return ask<AnyHit, std::uint32_t>(ray, mayHit, CountNothing{}, kNoPrimitive);
    }
    [[nodiscard]] std::uint32_t any(const Ray& ray, const MayHit& mayHit, RayTests& tests) const override {
        return ask<AnyHit, std::uint32_t>(ray, mayHit, CountTests{tests}, kNoPrimitive);
    }

protected:
    EngineInput input_;

private:
    template <typename Query, typename Answer, typename Count>
    Answer ask(const Ray& ray, const MayHit& mayHit, Count count, Answer nothing) const {
        if (!isUsable(ray)) return nothing;
        Query query(ray, input_.triangles, mayHit);
        static_cast<const Walk*>(this)->visit(ray, query, count);
        return query.answer();
    }
};

/// The triangles from `first` on to before `end` that can be hit at all, in their order.
std::vector<std::uint32_t> finiteTriangles(std::span<const Triangle> triangles, std::size_t first, std::size_t end);

} // namespace shadowlab::trace
