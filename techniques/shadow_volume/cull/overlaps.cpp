// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/cull/overlaps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <glm/gtc/constants.hpp>

#include "techniques/shadow_volume/cull/eye_line.h"

namespace shadowlab::shadow_volume {

namespace {

// An eight-bit stencil counts up to this. Once a bound is as small, no smaller one is searched for.
constexpr int kEnough = 255;

// Every axis gives a valid bound; the smallest is used. Several are tried, because a row of columns gives a poor bound
// along one of them.
constexpr int kTries = 4;

// Relative to the light's distance: closer to the axis than this an angle is only rounding.
constexpr double kOnAxis = 1e-9;

/// The largest number of intervals that share a point: every edge covers an interval of the sweep.
class Stabbed {
public:
    void add(double from, double to, int weight) {
        steps_.push_back({from, weight});
        steps_.push_back({to, -weight});
    }
    /// Of two edges that meet at a vertex a line beside the vertex crosses only one, so an end is sorted before a
    /// beginning.
    [[nodiscard]] int most() {
        std::ranges::sort(
            steps_, [](const Step& a, const Step& b) { return std::tie(a.at, a.weight) < std::tie(b.at, b.weight); });
        int sum = 0, most = 0;
        for (const Step& step : steps_)
            most = std::max(most, sum += step.weight);
        return most;
    }

private:
    struct Step {
        double at = 0;
        int weight = 0;
    };
    std::vector<Step> steps_;
};

template <typename Visit>
void forEachEdgeWorld(const scene::Scene& scene, std::span<const CasterVolume> casters, const Visit& visit) {
    for (const CasterVolume& caster : casters) {
        const scene::Object& object = scene.objects[caster.object];
        const dmat4 worldFromMesh = scene::worldFromMesh(object);
        const auto world = [&](std::uint32_t v) {
            return transformPoint(worldFromMesh, dvec3(object.mesh->positionsMesh[v]));
        };
        for (const SilhouetteEdge& edge : caster.silhouette)
            visit(world(edge.a), world(edge.b), static_cast<int>(edge.multiplicity));
    }
}

/// A unit vector perpendicular to the direction.
dvec3 squareTo(const dvec3& direction) {
    const dvec3 size = glm::abs(direction);
    const dvec3 least = size.x <= size.y && size.x <= size.z ? dvec3(1, 0, 0)
                        : size.y <= size.z                   ? dvec3(0, 1, 0)
                                                             : dvec3(0, 0, 1);
    return glm::normalize(glm::cross(direction, least));
}

/// A directional light: all half planes are parallel, and no triangle lies at their far end.
int mostUnderSun(const scene::Scene& scene, const scene::Light& light, std::span<const CasterVolume> casters) {
    const dvec3 across = squareTo(light.directionWorld),
                further = glm::cross(glm::normalize(light.directionWorld), across);
    int least = std::numeric_limits<int>::max();
    for (int i = 0; i < kTries && least > kEnough; ++i) {
        const double turned = glm::pi<double>() * i / kTries;
        const dvec3 sideways = std::cos(turned) * across + std::sin(turned) * further;
        Stabbed edges;
        forEachEdgeWorld(scene, casters, [&](const dvec3& a, const dvec3& b, int multiplicity) {
            const double atA = glm::dot(sideways, a), atB = glm::dot(sideways, b);
            edges.add(std::min(atA, atB), std::max(atA, atB), multiplicity);
        });
        least = std::min(least, edges.most() / 2);
    }
    return least;
}

/// Triangles of the caps that a ray from the light meets, or touches to within rounding.
int onRay(const scene::Scene& scene, const scene::Light& light, const CasterVolume& caster,
          const dvec3& directionWorld) {
    constexpr double kTouching = 1e-9;
    const scene::Object& object = scene.objects[caster.object];
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    int count = 0;
    for (const auto* cap : {&caster.volume.topCap, &caster.volume.topCapReversed})
        for (std::size_t i = 0; i + 2 < cap->size(); i += 3) {
            dvec3 corner[3];
            for (std::size_t k = 0; k < 3; ++k)
                corner[k] = transformPoint(worldFromMesh, dvec3(object.mesh->positionsMesh[(*cap)[i + k]])) -
                            light.positionWorld;
            bool left = true, right = true, ahead = false;
            for (int k = 0; k < 3; ++k) {
                const dvec3 &p = corner[k], &q = corner[(k + 1) % 3];
                const double side = glm::dot(directionWorld, glm::cross(p, q));
                const double slack = kTouching * glm::length(p) * glm::length(q);
                left = left && side >= -slack;
                right = right && side <= slack;
                ahead = ahead || glm::dot(directionWorld, p) >= 0;
            }
            count += (left || right) && ahead;
        }
    return count;
}

/// Calls visit(caster, direction) for each end of an axis through the light and each caster that it may meet.
template <typename Visit>
void forEachTouched(const dvec3& axisWorld, const scene::Light& light, std::span<const CasterVolume> casters,
                    const Visit& visit) {
    for (const double end : {1.0, -1.0})
        for (const CasterVolume& caster : casters)
            if (eyeLineMayTouch(caster.bounds, light.positionWorld, dvec4(end * axisWorld, 0.0)))
                visit(caster, end * axisWorld);
}

/// Axes for the half planes: of the 13 directions of a cube (faces, edges, diagonals) those whose ends meet the fewest
/// casters.
std::vector<dvec3> chooseAxes(const scene::Light& light, std::span<const CasterVolume> casters) {
    std::vector<std::pair<std::size_t, dvec3>> axes; // with the number of triangles that may be met
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                if (9 * x + 3 * y + z <= 0) continue; // each once
                const dvec3 axis = glm::normalize(dvec3(x, y, z));
                std::size_t triangles = 0;
                forEachTouched(axis, light, casters, [&](const CasterVolume& caster, const dvec3&) {
                    triangles += (caster.volume.topCap.size() + caster.volume.topCapReversed.size()) / 3;
                });
                axes.emplace_back(triangles, axis);
            }
    std::ranges::stable_sort(axes, {}, [](const auto& axis) { return axis.first; });
    std::vector<dvec3> best;
    for (const auto& [triangles, axis] : std::span(axes).first(kTries))
        best.push_back(axis);
    return best;
}

/// A light with a position: half planes at all angles around an axis through it.
int mostAround(const dvec3& axisWorld, const scene::Scene& scene, const scene::Light& light,
               std::span<const CasterVolume> casters) {
    const dvec3 across = squareTo(axisWorld), further = glm::cross(axisWorld, across);
    constexpr double kHalfTurn = glm::pi<double>();
    Stabbed edges;
    forEachEdgeWorld(scene, casters, [&](const dvec3& a, const dvec3& b, int multiplicity) {
        double angle[2];
        for (int i = 0; i < 2; ++i) {
            const dvec3 fromLight = (i == 0 ? a : b) - light.positionWorld;
            const dvec2 flat(glm::dot(across, fromLight), glm::dot(further, fromLight));
            if (glm::length(flat) <= kOnAxis * glm::length(fromLight))
                return edges.add(-kHalfTurn, kHalfTurn, multiplicity);
            angle[i] = std::atan2(flat.y, flat.x);
        }
        // Along an edge the angle goes one way, by less than half a turn.
        const double least = std::min(angle[0], angle[1]), most = std::max(angle[0], angle[1]);
        if (std::abs(most - least - kHalfTurn) < kOnAxis) return edges.add(-kHalfTurn, kHalfTurn, multiplicity);
        if (most - least < kHalfTurn) return edges.add(least, most, multiplicity);
        edges.add(most, kHalfTurn, multiplicity);
        edges.add(-kHalfTurn, least, multiplicity);
    });
    int atEnds = 0;
    forEachTouched(axisWorld, light, casters, [&](const CasterVolume& caster, const dvec3& direction) {
        atEnds += onRay(scene, light, caster, direction);
    });
    return (edges.most() + atEnds) / 2;
}

} // namespace

int mostOverlaps(const scene::Scene& scene, const scene::Light& light, std::span<const CasterVolume> casters) {
    if (light.type == scene::LightType::directional) return mostUnderSun(scene, light, casters);
    int least = std::numeric_limits<int>::max();
    for (const dvec3& axis : chooseAxes(light, casters))
        if (least > kEnough) least = std::min(least, mostAround(axis, scene, light, casters));
    return least;
}

} // namespace shadowlab::shadow_volume
