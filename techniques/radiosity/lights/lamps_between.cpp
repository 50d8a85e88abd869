// SPDX-License-Identifier: MIT
#include "techniques/radiosity/lights/lamps_between.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/trace/parallel.h"
#include "techniques/radiosity/form_factors/visible_exchange.h"

namespace shadowlab::radiosity {

namespace {

// Lines of a patch if lamps were between it and all others. What lamps take of its light is then right to about a hundredth.
constexpr double kLinesPastLamps = 4e4;

/// The point of a line that is nearest to that one.
dvec3 nearestOn(const dvec3& from, const dvec3& to, const dvec3& point) {
    const dvec3 way = to - from;
    const double square = glm::dot(way, way);
    return square > 0 ? from + glm::clamp(glm::dot(point - from, way) / square, 0.0, 1.0) * way : from;
}

} // namespace

double surfaceArea(const scene::Object& object) {
    const dmat3 worldFromMesh(scene::worldFromMesh(object));
    double area = 0;
    for (const uvec3& t : object.mesh->triangles) {
        const auto corner = [&](int i) { return worldFromMesh * dvec3(object.mesh->positionsMesh[t[i]]); };
        area += glm::length(areaVector({corner(0), corner(1), corner(2)}));
    }
    return area;
}

LampBody::LampBody(const scene::Light& lamp, const scene::Object& surface, const dvec3& originWorld) : middle_(lamp.positionWorld - originWorld) {
    if (lamp.type == scene::LightType::sphere) {
        // A mesh of flat faces hides as much as a ball of the same surface (A. Cauchy: in the mean over all directions, a quarter of it).
        radius_ = reach_ = std::sqrt(surfaceArea(surface) / (4 * glm::pi<double>()));
        return;
    }
    const dvec3 u = 0.5 * lamp.edgeUWorld, v = 0.5 * lamp.edgeVWorld, across = glm::cross(u, v);
    normal_ = glm::normalize(across);
    alongU_ = glm::cross(v, across) / glm::dot(across, across);
    alongV_ = glm::cross(across, u) / glm::dot(across, across);
    reach_ = std::max(glm::length(u + v), glm::length(u - v));
}

bool LampBody::blocks(const dvec3& fromCentred, const dvec3& toCentred) const {
    if (radius_ > 0) return holds(nearestOn(fromCentred, toCentred, middle_));
    const double from = glm::dot(normal_, fromCentred - middle_), to = glm::dot(normal_, toCentred - middle_);
    if (!((from > 0 && to < 0) || (from < 0 && to > 0))) return false;
    const dvec3 off = glm::mix(fromCentred, toCentred, from / (from - to)) - middle_;
    return std::abs(glm::dot(off, alongU_)) <= 1 && std::abs(glm::dot(off, alongV_)) <= 1;
}

bool LampBody::mayBlock(const dvec3& fromCentred, const dvec3& toCentred, double around) const {
    return glm::distance(nearestOn(fromCentred, toCentred, middle_), middle_) <= reach_ + around;
}

LampsBetweenBuilder::LampsBetweenBuilder(const Room& room, std::vector<LampBody> lamps) : room_(room), lamps_(std::move(lamps)), rows_(room.patches().size()) {
    for (const Patch& patch : room.patches()) {
        double& size = sizes_.emplace_back(0);
        for (const dvec3& corner : patch.polygon.corners())
            size = std::max(size, glm::distance(corner, patch.centre));
    }
}

bool LampsBetweenBuilder::advance(std::chrono::steady_clock::time_point deadline) {
    next_ = trace::parallelUntil(deadline, next_, rows_.size(), [&](std::size_t row) { fill(row); });
    return next_ == rows_.size();
}

void LampsBetweenBuilder::fill(std::size_t row) {
    const std::vector<Patch>& patches = room_.patches();
    const Patch& patch = patches[row];
    std::optional<Blockers> ofFace; // between the patch and the face of the other, found if it is asked for
    for (std::size_t j = row + 1; j < patches.size(); ++j) {
        if (patches[j].face != patches[j - 1].face) ofFace.reset();
        const double around = std::max(sizes_[row], sizes_[j]);
        const bool mayBe = patches[j].face != patch.face &&
                           std::ranges::any_of(lamps_, [&](const LampBody& lamp) { return lamp.mayBlock(patch.centre, patches[j].centre, around); });
        if (!mayBe) continue;
        const double share = sharePast(patch, patches[j], ofFace);
        if (share < 1) rows_[row].push_back({static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(j), share});
    }
}

/// Of the weight of all lines that nothing else blocks, and that do not begin or end within a lamp, that of those that meet none.
double LampsBetweenBuilder::sharePast(const Patch& a, const Patch& b, std::optional<Blockers>& ofFace) const {
    if (isBehind(a.plane(), b.polygon, 0) || isBehind(b.plane(), a.polygon, 0)) return 1;
    const double roughly = exchangeKernel(a, b, a.centre, b.centre) * a.area * b.area / glm::pi<double>();
    const int lines = linesBetween(a, b, roughly, kLinesPastLamps);
    const auto shareWhere = [&](const auto& isFree) {
        double all = 0, past = 0;
        forLinesBetween(a, b, lines, [&](const dvec3& from, const dvec3& to, double weight) {
            const bool isWithin = std::ranges::any_of(lamps_, [&](const LampBody& lamp) { return lamp.holds(from) || lamp.holds(to); });
            if (!(weight > 0) || isWithin || !isFree(from, to)) return;
            all += weight;
            if (std::ranges::none_of(lamps_, [&](const LampBody& lamp) { return lamp.blocks(from, to); })) past += weight;
        });
        return all > 0 ? past / all : 1;
    };
    const double share = shareWhere([](const dvec3&, const dvec3&) { return true; });
    if (share == 0 || share == 1) return share;
    const Occlusion& occlusion = room_.occlusion();
    if (!ofFace) ofFace = occlusion.between(a.polygon, room_.exchangingFaces().all[b.face].polygon);
    const Blockers blockers = ofFace->empty() ? Blockers() : occlusion.between(a.polygon, b.polygon, &*ofFace);
    if (blockers.empty()) return share;
    return shareWhere([&](const dvec3& from, const dvec3& to) { return !occlusion.isBlocked(blockers, from, to); });
}

std::vector<PairValue> LampsBetweenBuilder::take() {
    std::vector<PairValue> all;
    for (const std::vector<PairValue>& row : rows_)
        all.insert(all.end(), row.begin(), row.end());
    return all;
}

std::vector<PairValue> leaveShares(ExchangeMatrix& matrix, std::span<const PairValue> shares) {
    std::vector<PairValue> before;
    for (const auto& [i, j, share] : shares) {
        const double there = matrix(i, j);
        before.push_back({i, j, there});
        matrix.set(i, j, share * there);
    }
    return before;
}

void putBack(ExchangeMatrix& matrix, std::span<const PairValue> before) {
    for (const auto& [i, j, there] : before)
        matrix.set(i, j, there);
}

} // namespace shadowlab::radiosity
