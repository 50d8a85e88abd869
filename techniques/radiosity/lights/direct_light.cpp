// SPDX-License-Identifier: MIT
#include "techniques/radiosity/lights/direct_light.h"

#include <utility>

#include "techniques/foundation/trace/parallel.h"
#include "techniques/radiosity/patches/polygon_samples.h"

namespace shadowlab::radiosity {

namespace {

// So many lines estimate a partly visible share to about 1/40; a patch is hardly smaller than a shadow's edge anyway.
constexpr int kLines = 64;

/// Sums over the lines to a light: of their weights and of their number, with and without occlusion.
struct LineSamples {
    double free = 0, all = 0, freeCount = 0, count = 0;
    /// `countWeight`: the weight of the line where every part of the light counts alike.
    void add(double weight, double countWeight, bool isFree) {
        all += weight;
        count += countWeight;
        if (isFree) free += weight;
        if (isFree && weight > 0) freeCount += countWeight;
    }
    [[nodiscard]] double share() const { return all > 0 ? free / all : 0; }
    [[nodiscard]] double seenArea() const { return count > 0 ? freeCount / count : 0; }
};

} // namespace

DirectLightBuilder::DirectLightBuilder(LightSource source, const std::vector<Patch>& patches,
                                       const Occlusion& occlusion, std::vector<std::uint8_t> receivesShadow)
    : source_(std::move(source)), patches_(patches), occlusion_(occlusion), receivesShadow_(std::move(receivesShadow)) {
    light_.irradiance.resize(patches.size(), dvec3(0.0));
    light_.visible.resize(patches.size(), 0.0);
    light_.mayHaveEdge.resize(patches.size(), 0);
    light_.cells.resize(patches.size(), {});
    light_.seenArea.resize(patches.size(), 0.0);
}

bool DirectLightBuilder::advance(std::chrono::steady_clock::time_point deadline) {
    next_ = trace::parallelUntil(deadline, next_, patches_.size(), [&](std::size_t i) { fill(i); });
    return next_ == patches_.size();
}

double DirectLightBuilder::done() const {
    return patches_.empty() ? 1 : static_cast<double>(next_) / static_cast<double>(patches_.size());
}

// [anchor: light-on-a-patch]
void DirectLightBuilder::fill(std::size_t i) {
    const Patch& patch = patches_[i];
    const double whole = source_.meanIrradiance(patch);
    if (!(whole > 0)) return;
    const Blockers blockers = receivesShadow_[i] ? source_.blockers(patch.polygon, occlusion_) : Blockers{};
    if (!blockers.empty() && source_.isHidden(patch.polygon, occlusion_, blockers)) return;
    light_.mayHaveEdge[i] = blockers.empty() ? 0 : 1;
    sampleLines(i, blockers);
    if (blockers.empty()) light_.visible[i] = 1; // no sampling needed
    light_.irradiance[i] = light_.visible[i] * whole * source_.color();
}

void DirectLightBuilder::sampleLines(std::size_t i, const Blockers& blockers) {
    const Patch& patch = patches_[i];
    const Polygon reached = source_.reached(patch);
    if (reached.isEmpty()) return;
    LineSamples samples;
    const PatchCells cells(patch.polygon);
    PatchCells::Shares& shares = light_.cells[i];
    for (int l = 0; l < kLines; ++l) {
        const auto x = hammersley4(l, kLines);
        const Place place = placeIn(reached, x[0], x[1]);
        const LightLine line = source_.line(place.point, patch.normal, x[2], x[3]);
        const bool isFree =
            line.weight > 0 && (blockers.empty() || !occlusion_.isBlocked(blockers, place.point, line.fromCentred));
        samples.add(place.weight * line.weight, place.weight, isFree);
        if (isFree) shares[cells.at(place.point)] += static_cast<float>(place.weight * line.weight);
    }
    if (samples.free > 0)
        for (float& share : shares)
            share /= static_cast<float>(samples.free);
    light_.visible[i] = samples.share();
    light_.seenArea[i] = samples.seenArea();
}

Arriving arrivingAt(const dvec3& positionCentred, const dvec3& normal, const LightSource& source,
                    const IsBlocked& isBlocked) {
    const double whole = source.irradiance(positionCentred, normal);
    if (!source.hasArea()) {
        const bool isFree = !isBlocked(positionCentred, source.line(positionCentred, normal, 0, 0).fromCentred);
        return {(isFree ? whole : 0.0) * source.color(), isFree ? 1.0 : 0.0};
    }
    if (!(whole > 0)) return {};
    LineSamples samples;
    for (int i = 0; i < kLines; ++i) {
        const auto x = hammersley4(i, kLines);
        const LightLine line = source.line(positionCentred, normal, x[0], x[1]);
        samples.add(line.weight, 1, line.weight > 0 && !isBlocked(positionCentred, line.fromCentred));
    }
    return {samples.share() * whole * source.color(), samples.seenArea()};
}

} // namespace shadowlab::radiosity
