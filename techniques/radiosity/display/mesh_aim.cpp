// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/mesh_aim.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <glm/gtc/constants.hpp>

#include "techniques/radiosity/display/gather_guide.h"
#include "techniques/radiosity/lights/lamps_between.h"
#include "techniques/radiosity/patches/polygon.h"
#include "techniques/radiosity/patches/polygon_samples.h"

namespace shadowlab::radiosity {

namespace {

// A convex body is seen, in the mean over all directions, as a quarter of its surface (A. Cauchy). If that is less than this share of the discs of its spheres, points
// leave less noise: by its group what a point brings has a variance of 0.2 times the square of its mean (MeshAim.GroupsAreAsLikelyAsTheyBringLight),
// and so have directions of which so many meet something.
constexpr double kFull = 1 / 1.2;

// Groups of a mesh. A ring has then 16 along it, each of 8 that face different ways; with four times as many, pictures had as much noise.
constexpr std::size_t kGroups = 128;

// A side turned by a right angle is as different as one across the whole mesh.
constexpr double kTurned = 0.7;

// As much of a group is seen at least, and its light comes in at a cosine of at least so much: it has some depth, and the receiver more places than its middle.
constexpr double kLeastSeen = 0.05;

/// What facets are told apart by.
std::array<double, 6> measuresOf(const dvec3& middle, const dvec3& across, double size) {
    const dvec3 place = middle / size, normal = kTurned * across / std::max(glm::length(across), 1e-300);
    return {place.x, place.y, place.z, normal.x, normal.y, normal.z};
}

} // namespace

MeshAim::MeshAim(const scene::Scene& scene, const scene::Object& object) : spheres_(object), groupOf_(object.mesh->triangles.size()) {
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    const double side = scene::isMirrored(object) ? -1 : 1;
    scene::Bounds bounds;
    for (std::uint32_t t = 0; t < object.mesh->triangles.size(); ++t) {
        const auto corner = [&](int i) { return transformPoint(worldFromMesh, dvec3(object.mesh->positionsMesh[object.mesh->triangles[t][i]])); };
        Facet facet{{corner(0), corner(1), corner(2)}, {}, t, 0};
        facet.across = side * areaVector({facet.corners[0], facet.corners[1], facet.corners[2]});
        facet.material = static_cast<std::uint32_t>(&scene::materialOfTriangle(scene, object, t) - scene.materials.data());
        for (const dvec3& one : facet.corners) bounds.include(one);
        facets_.push_back(facet);
    }
    if (0.25 * surfaceArea(object) < kFull * spheres_.discs()) spheres_ = {};
    const double size = std::max(glm::length(bounds.upperWorld - bounds.lowerWorld), 1e-300);
    std::ranges::stable_sort(facets_, {}, &Facet::material);
    for (std::size_t first = 0; first < facets_.size();) {
        const auto next = usesSpheres() ? facets_.end() : std::ranges::upper_bound(facets_, facets_[first].material, {}, &Facet::material);
        const auto count = static_cast<std::size_t>(next - facets_.begin()) - first;
        part(first, count, usesSpheres() ? 1 : (kGroups * count + facets_.size() - 1) / facets_.size(), size);
        first += count;
    }
    upTo_.resize(facets_.size());
    for (Group& group : groups_)
        fill(scene, group);
}

/// In two halves, by what they differ in most, until there are as many groups as are wanted.
void MeshAim::part(std::size_t first, std::size_t count, std::size_t wanted, double size) {
    const std::span<Facet> facets = std::span(facets_).subspan(first, count);
    wanted = std::min(wanted, count);
    if (wanted <= 1) {
        groups_.push_back({first, count});
        return;
    }
    std::array<double, 6> least, most;
    least.fill(1e300), most.fill(-1e300);
    for (const Facet& facet : facets) {
        const auto measures = measuresOf(facet.middle(), facet.across, size);
        for (std::size_t m = 0; m < measures.size(); ++m)
            least[m] = std::min(least[m], measures[m]), most[m] = std::max(most[m], measures[m]);
    }
    std::size_t widest = 0;
    for (std::size_t m = 1; m < least.size(); ++m)
        if (most[m] - least[m] > most[widest] - least[widest]) widest = m;
    const std::size_t half = count * (wanted / 2) / wanted;
    const auto measure = [&](const Facet& facet) { return measuresOf(facet.middle(), facet.across, size)[widest]; };
    std::ranges::nth_element(facets, facets.begin() + static_cast<std::ptrdiff_t>(half), {}, measure);
    part(first, half, wanted / 2, size);
    part(first + half, count - half, wanted - wanted / 2, size);
}

void MeshAim::fill(const scene::Scene& scene, Group& group) {
    const std::span<const Facet> facets = std::span(facets_).subspan(group.first, group.count);
    for (std::size_t i = 0; i < facets.size(); ++i) {
        const double area = glm::length(facets[i].across);
        group.area += area;
        group.across += facets[i].across;
        group.middleWorld += area * facets[i].middle();
        upTo_[group.first + i] = group.area;
        groupOf_[facets[i].number] = static_cast<std::uint32_t>(&group - groups_.data());
    }
    if (!(group.area > 0)) return;
    group.middleWorld /= group.area;
    for (const Facet& facet : facets) {
        const dvec3 off = facet.middle() - group.middleWorld;
        const scene::Material& material = scene.materials[facet.material];
        const double share = glm::length(facet.across) / group.area;
        group.spread += share * glm::dot(off, off);
        group.emitted += share * glm::pi<double>() * luminance(dvec3(material.emission));
        group.hasTwoSides = group.hasTwoSides || material.emits == scene::EmittingSides::both;
    }
}

double MeshAim::likely(std::size_t number, const Receiver& at, double reflected) const {
    if (spheres_.hold(at.positionWorld)) return 0;
    const Group& group = groups_[number];
    const dvec3 way = group.middleWorld - at.positionWorld;
    const double squared = std::max(glm::dot(way, way), 1e-300);
    const dvec3 direction = way / std::sqrt(squared);
    // From another place of the receiver the way differs by about this angle (the sine), and may lead to more of the group.
    const double off = std::sqrt(0.25 * at.area / (squared + 0.25 * at.area)), facing = glm::length(group.across);
    const double turned = -glm::dot(group.across, direction);
    const double front = glm::clamp((group.hasTwoSides ? std::abs(turned) : turned) + off * facing, 0.0, facing);
    // Facets that face all ways show a quarter of their area (A. Cauchy).
    const double seen = front + 0.25 * (group.area - facing) + kLeastSeen * group.area;
    const double cosineHere = glm::clamp(glm::dot(at.normal, direction) + off, kLeastSeen, 1.0);
    return (group.emitted + reflected) * seen * cosineHere / (squared + group.spread + 0.25 * at.area);
}

double MeshAim::emitted() const {
    double sum = 0;
    for (const Group& group : groups_)
        sum += group.emitted * group.area * (group.hasTwoSides ? 2 : 1);
    return sum;
}

std::optional<MeshAim::Way> MeshAim::choose(std::size_t number, const dvec3& fromWorld, double which, const dvec2& where) const {
    if (usesSpheres()) {
        const auto direction = spheres_.direction(fromWorld, which, where);
        if (!direction) return std::nullopt;
        return Way{*direction, 0, spheres_.density(fromWorld, *direction)};
    }
    const Group& group = groups_[number];
    const std::span<const double> upTo = std::span(upTo_).subspan(group.first, group.count);
    const auto above = static_cast<std::size_t>(std::ranges::upper_bound(upTo, which * group.area) - upTo.begin());
    const Facet& facet = facets_[group.first + std::min(above, group.count - 1)];
    const dvec3 way = evenPlaceIn({facet.corners[0], facet.corners[1], facet.corners[2]}, where.x, where.y) - fromWorld;
    const double distance = glm::length(way), cosine = std::abs(glm::dot(way, facet.across)) / (distance * glm::length(facet.across));
    if (!(distance > kContactDistance) || !(cosine > 0)) return std::nullopt;
    return Way{way / distance, distance, density(number, fromWorld, way / distance, distance, cosine)};
}

double MeshAim::density(std::size_t group, const dvec3& fromWorld, const dvec3& direction, double distance, double cosineThere) const {
    return usesSpheres() ? spheres_.density(fromWorld, direction) : densityOfDirection(1 / groups_[group].area, distance, cosineThere);
}

} // namespace shadowlab::radiosity
