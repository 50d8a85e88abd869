// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/area/area_visibility.h"

#include <algorithm>
#include <stdexcept>

#include "techniques/foundation/trace/area/area_asker.h"

namespace shadowlab::trace {

namespace {

// So few points, or so few triangles, are not split further: each point tests all triangles found for the group.
constexpr std::size_t kFewPoints = 8, kFewTriangles = 24;

// Lower than this share of the light's distance above a point's plane, a triangle is in that plane: rounding of coordinates is
// a thousand times smaller, and what it could hide of the light no larger.
constexpr double kInPlane = 1e-12;

// A triangle is tested against the planes of at most this many points; beyond that it is cheaper to keep it.
constexpr std::size_t kMostPlanes = 8;

CentredBox boxOfLight(const scene::Light& light, const dvec3& centreCentred) {
    CentredBox box;
    if (light.type == scene::LightType::sphere) {
        box.include(centreCentred);
        box.grow(light.radius);
        return box;
    }
    for (const double u : {-0.5, 0.5})
        for (const double v : {-0.5, 0.5})
            box.include(centreCentred + u * light.edgeUWorld + v * light.edgeVWorld);
    return box;
}

} // namespace

/// The points of one query.
struct AreaVisibility::Group {
    std::span<const SurfacePoint> points;
    std::span<const double> moves;
    std::span<AreaShare> shares;
    std::span<const dvec3> normalsWorld;
    std::span<AreaIrradiance> irradiances; ///< shares or irradiances, whichever are asked for
    std::vector<dvec3> positionsCentred{};
    [[nodiscard]] double move(std::uint32_t i) const { return moves.empty() ? 0.0 : moves[i]; }
    /// Around some of them, and all places they move to.
    [[nodiscard]] CentredBox box(std::span<const std::uint32_t> members) const {
        CentredBox box;
        for (const std::uint32_t i : members) {
            box.include(positionsCentred[i] - move(i));
            box.include(positionsCentred[i] + move(i));
        }
        return box;
    }
};

AreaVisibility::AreaVisibility(const SceneTracer& tracer, int light)
    : tracer_(tracer), light_(tracer.scene().light(light)), number_(light),
      centreCentred_(light_.positionWorld - tracer.world().originWorld), box_(boxOfLight(light_, centreCentred_)),
      edges_(tracer.scene(), tracer.world()) {
    if (!scene::hasArea(light_)) throw std::logic_error("the visible area of a light that has none");
    const std::span<const std::uint8_t> casters = tracer.castersFor(light);
    casts_.assign(casters.begin(), casters.end());
}

double AreaVisibility::share(const SurfacePoint& point) const {
    AreaShare answer;
    shares({&point, 1}, {}, {&answer, 1});
    return answer.visible;
}

void AreaVisibility::shares(std::span<const SurfacePoint> points, std::span<const double> moves,
                            std::span<AreaShare> answers) const {
    std::ranges::fill(answers, AreaShare());
    Group group{points, moves, answers, {}, {}};
    askAll(group);
}

void AreaVisibility::irradiances(std::span<const SurfacePoint> points, std::span<const dvec3> normalsWorld,
                                 std::span<AreaIrradiance> answers) const {
    std::ranges::fill(answers, AreaIrradiance());
    Group group{points, {}, {}, normalsWorld, answers};
    askAll(group);
}

void AreaVisibility::askAll(Group& group) const {
    group.positionsCentred.resize(group.points.size());
    std::vector<std::uint32_t> asking;
    for (std::uint32_t i = 0; i < group.points.size(); ++i) {
        const SurfacePoint& point = group.points[i];
        if (!point || !tracer_.facesLight(point, number_)) continue;
        if (!tracer_.objectOf(point).receivesShadow && group.irradiances.empty()) {
            group.shares[i].visible = 1;
            continue;
        }
        group.positionsCentred[i] = tracer_.positionCentred(point);
        asking.push_back(i);
    }
    if (asking.empty()) return;
    ask(group, asking, Shaft(group.box(asking), box_).triangles(tracer_.bvh(), [&](std::uint32_t primitive) {
        return casts_[primitive] != 0;
    }));
}

/// Splits the points if that leaves fewer triangles for each half.
void AreaVisibility::ask(Group& group, std::span<std::uint32_t> members, std::vector<std::uint32_t> candidates) const {
    const CentredBox box = group.box(members);
    const Shaft shaft(box, box_);
    std::erase_if(candidates, [&](std::uint32_t primitive) {
        const Triangle& triangle = tracer_.bvh().triangles[primitive];
        return !shaft.mayTouch(triangle) || isBelowAll(group, members, triangle);
    });
    if (members.size() <= kFewPoints || candidates.size() <= kFewTriangles)
        return askTogether(group, members, candidates);
    const dvec3 size = box.upper - box.lower;
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const std::size_t half = members.size() / 2;
    std::ranges::nth_element(members, members.begin() + static_cast<std::ptrdiff_t>(half), [&](auto i, auto j) {
        const double a = group.positionsCentred[i][axis], b = group.positionsCentred[j][axis];
        return a != b ? a < b : i < j;
    });
    ask(group, members.first(half), candidates);
    ask(group, members.subspan(half), std::move(candidates));
}

void AreaVisibility::askTogether(Group& group, std::span<const std::uint32_t> members,
                                 const std::vector<std::uint32_t>& candidates) const {
    double largestMove = 0;
    for (const std::uint32_t i : members)
        largestMove = std::max(largestMove, group.move(i));
    Asker asker(*this, group.box(members), largestMove, candidates);
    for (const std::uint32_t i : members)
        if (group.irradiances.empty())
            group.shares[i] = asker.ask(group.points[i], group.move(i));
        else
            group.irradiances[i] = asker.askIrradiance(group.points[i], group.normalsWorld[i]);
}

/// True if the triangle is below the plane of each of these points, so that it hides nothing from them.
bool AreaVisibility::isBelowAll(const Group& group, std::span<const std::uint32_t> members,
                                const Triangle& triangle) const {
    std::size_t planes = 0;
    std::uint32_t last = kNoPrimitive;
    for (const std::uint32_t i : members) {
        const SurfacePoint& point = group.points[i];
        if (point.primitive == last) continue; // another point of the same plane
        if (++planes > kMostPlanes) return false;
        last = point.primitive;
        const Triangle& own = tracer_.bvh().triangles[last];
        dvec3 up = glm::normalize(glm::cross(own.b - own.a, own.c - own.a));
        if (!point.eyeOnFront) up = -up;
        const double level = glm::dot(up, own.a) + kInPlane * glm::length(centreCentred_ - group.positionsCentred[i]);
        if (glm::dot(up, triangle.a) > level || glm::dot(up, triangle.b) > level || glm::dot(up, triangle.c) > level)
            return false;
    }
    return true;
}

} // namespace shadowlab::trace
