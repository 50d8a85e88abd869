// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/area/area_visibility.h"

#include <algorithm>
#include <stdexcept>

#include "techniques/foundation/trace/area/area_asker.h"
#include "techniques/foundation/trace/area/obstacles.h"

namespace shadowlab::trace {

namespace {

// So few points, or points with so few obstacles, are not split further: each point tests all that was found for the group.
constexpr std::size_t kFewPoints = 8, kFewObstacles = 8;

// Obstacles are tested against at most so many horizons; with more it is cheaper to keep those below.
constexpr std::size_t kMostHorizons = 8;

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
};

AreaVisibility::AreaVisibility(const SceneTracer& tracer, int light)
    : tracer_(tracer), light_(tracer.scene().light(light)), number_(light),
      centreCentred_(light_.positionWorld - tracer.world().originWorld), box_(boxOfLight(light_, centreCentred_)),
      edges_(tracer.scene(), tracer.world()) {
    if (!scene::hasArea(light_)) throw std::logic_error("the visible area of a light that has none");
    const std::span<const std::uint8_t> casters = tracer.castersFor(light);
    casts_.assign(casters.begin(), casters.end());
    if (light_.type != scene::LightType::sphere) return;
    cuts_ = SphereCuts(centreCentred_, light_.radius);
    const Shaft around(box_, box_); // what touches the light's box
    for (const std::uint32_t primitive : around.triangles(tracer.bvh(), [&](std::uint32_t candidate) { return casts_[candidate] != 0; }))
        cuts_.add(tracer.bvh().triangles[primitive], primitive);
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
        if (!point || !(group.irradiances.empty() ? tracer_.facesLight(point, number_) : tracer_.mayFacePartOfLight(point, number_))) continue;
        if (!tracer_.objectOf(point).receivesShadow && group.irradiances.empty()) {
            group.shares[i].visible = 1;
            continue;
        }
        group.positionsCentred[i] = tracer_.positionCentred(point);
        asking.push_back(i);
    }
    if (asking.empty()) return;
    const Bounds bounds = boundsOf(group, asking);
    Asker asker(*this);
    ask(group, asking, bounds, Obstacles(*this, bounds), asker);
}

/// Splits the points where that leaves fewer obstacles for each half.
void AreaVisibility::ask(Group& group, std::span<std::uint32_t> members, const Bounds& bounds,
                         const Obstacles& obstacles, Asker& asker) const {
    // Chords of cuts are about as many for each part of the points.
    if (members.size() <= kFewPoints || obstacles.count() - obstacles.cuts.size() <= kFewObstacles)
        return askTogether(group, members, obstacles, asker);
    const dvec3 size = bounds.box.upper - bounds.box.lower;
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const double middle = 0.5 * (bounds.box.upper[axis] + bounds.box.lower[axis]);
    // In the middle of the box, not of their number: so bodies that one sees beside each other come apart.
    const auto second =
        std::ranges::partition(members, [&](auto i) { return group.positionsCentred[i][axis] < middle; });
    const std::size_t first = members.size() - second.size();
    if (first == 0 || second.empty()) return askTogether(group, members, obstacles, asker); // all in one place
    for (const std::span<std::uint32_t> part : {members.first(first), members.subspan(first)}) {
        const Bounds ofPart = boundsOf(group, part);
        ask(group, part, ofPart, obstacles.narrowed(*this, ofPart), asker);
    }
}

void AreaVisibility::askTogether(Group& group, std::span<const std::uint32_t> members, const Obstacles& obstacles,
                                 Asker& asker) const {
    asker.setObstacles(obstacles);
    for (const std::uint32_t i : members)
        if (group.irradiances.empty())
            group.shares[i] = asker.ask(group.points[i], group.move(i));
        else
            group.irradiances[i] = askIrradiance(group.points[i], group.normalsWorld[i], asker);
}

AreaIrradiance AreaVisibility::askIrradiance(const SurfacePoint& point, const dvec3& normalWorld, Asker& asker) const {
    AreaIrradiance answer = asker.askIrradiance(point, normalWorld);
    if (!tracer_.facesLight(point, number_)) answer.visible = 0;
    return answer;
}

AreaVisibility::Bounds AreaVisibility::boundsOf(const Group& group, std::span<const std::uint32_t> members) const {
    Bounds bounds;
    std::vector<std::uint32_t> triangles; // of those horizons
    for (const std::uint32_t i : members) {
        bounds.largestMove = std::max(bounds.largestMove, group.move(i));
        bounds.box.include(group.positionsCentred[i] - group.move(i));
        bounds.box.include(group.positionsCentred[i] + group.move(i));
        const SurfacePoint& point = group.points[i];
        if (triangles.size() > kMostHorizons || std::ranges::find(triangles, point.primitive) != triangles.end())
            continue;
        triangles.push_back(point.primitive);
        const Triangle& own = tracer_.bvh().triangles[point.primitive];
        const dvec3 up = (point.eyeOnFront ? 1.0 : -1.0) * glm::normalize(frontOf(own));
        bounds.horizons.push_back(
            {up, glm::dot(up, own.a) + kInPlane * glm::length(centreCentred_ - group.positionsCentred[i])});
    }
    if (triangles.size() > kMostHorizons) bounds.horizons.clear();
    return bounds;
}

double AreaVisibility::nearness(double move, double farthest) const {
    const double leastHalf = light_.type == scene::LightType::sphere
                                 ? kLeastDisc * light_.radius
                                 : 0.5 * glm::length(glm::cross(light_.edgeUWorld, light_.edgeVWorld)) /
                                       std::max(glm::length(light_.edgeUWorld), glm::length(light_.edgeVWorld));
    return move * farthest / (kMargin * leastHalf);
}

} // namespace shadowlab::trace
