// SPDX-License-Identifier: MIT
#include "techniques/radiosity/direct_light.h"

#include <utility>

#include "techniques/foundation/trace/parallel.h"
#include "techniques/radiosity/even_places.h"

namespace shadowlab::radiosity {

namespace {

// They miss what is seen in part by 1/40 or so; and a patch is no smaller than a shadow's edge anyway.
constexpr int kLines = 64;

/// Of lines that are tried, the share of their weight that is free.
struct Tried {
    double free = 0, all = 0;
    void add(double weight, bool isFree) {
        all += weight;
        if (isFree) free += weight;
    }
    [[nodiscard]] double share() const { return all > 0 ? free / all : 0; }
};

} // namespace

DirectLightBuilder::DirectLightBuilder(LightSource source, const std::vector<Patch>& patches,
                                       const Occlusion& occlusion, std::vector<std::uint8_t> receivesShadow)
    : source_(std::move(source)), patches_(patches), occlusion_(occlusion),
      receivesShadow_(std::move(receivesShadow)), light_{std::vector<dvec3>(patches.size(), dvec3(0.0)),
                                                         std::vector<double>(patches.size(), 0.0)} {}

bool DirectLightBuilder::advance(std::chrono::steady_clock::time_point deadline) {
    next_ = trace::parallelUntil(deadline, next_, patches_.size(), [&](std::size_t i) { fill(i); });
    return next_ == patches_.size();
}

double DirectLightBuilder::done() const {
    return patches_.empty() ? 1 : static_cast<double>(next_) / static_cast<double>(patches_.size());
}

void DirectLightBuilder::fill(std::size_t i) {
    const Patch& patch = patches_[i];
    const double whole = source_.meanIrradiance(patch);
    if (!(whole > 0)) return;
    const double visible = receivesShadow_[i] ? visibleShare(patch) : 1;
    light_.irradiance[i] = visible * whole * source_.color();
    light_.visible[i] = visible;
}

double DirectLightBuilder::visibleShare(const Patch& patch) const {
    const Blockers blockers = source_.blockers(patch.polygon, occlusion_);
    if (blockers.empty()) return 1;
    if (source_.isHidden(patch.polygon, occlusion_, blockers)) return 0;
    const Polygon reached = source_.reached(patch);
    if (reached.isEmpty()) return 0;
    Tried tried;
    for (int i = 0; i < kLines; ++i) {
        const auto x = evenly(i, kLines);
        const Place place = placeIn(reached, x[0], x[1]);
        const LightLine line = source_.line(place.point, patch.normal, x[2], x[3]);
        if (line.weight > 0)
            tried.add(place.weight * line.weight, !occlusion_.hide(blockers, place.point, line.fromCentred));
    }
    return tried.share();
}

Arriving arrivingAt(const dvec3& positionCentred, const dvec3& normal, const LightSource& source,
                    const Occlusion& occlusion, const Blockers& blockers) {
    const double whole = source.irradiance(positionCentred, normal);
    if (!(whole > 0)) return {};
    if (blockers.empty()) return {whole * source.color(), 1};
    Tried tried;
    const int lines = source.hasArea() ? kLines : 1;
    for (int i = 0; i < lines; ++i) {
        const auto x = evenly(i, lines);
        const LightLine line = source.line(positionCentred, normal, x[0], x[1]);
        if (line.weight > 0) tried.add(line.weight, !occlusion.hide(blockers, positionCentred, line.fromCentred));
    }
    return {tried.share() * whole * source.color(), tried.share()};
}

} // namespace shadowlab::radiosity
