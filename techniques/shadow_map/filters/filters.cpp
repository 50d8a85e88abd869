// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/filters/filters.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/base/error.h"
#include "techniques/shadow_map/filters/moment_filters.h"
#include "techniques/shadow_map/probe/map_probe.h"

namespace shadowlab::shadow_map {

namespace {

double momentRadius(const FilterParams& p) { return p.blurRadius + 1; } // moments are interpolated between texels

constexpr FilterInfo kFilters[] = {
    {.name = "hard",
     .what = "one comparison",
     .shader = "shadow_map/filters/filter_hard.glsl",
     .anchors = {"compare-hard"},
     .answer = hardAnswer},
    {.name = "hw2x2",
     .what = "2 x 2 by hardware (bilinear)",
     .shader = "shadow_map/filters/filter_hw2x2.glsl",
     .anchors = {"compare-hw2x2"},
     .kernel = KernelForm::fourTexels,
     .radiusTexels = [](const FilterParams&) { return 0.5; },
     .sampling = gl::DepthSampling::compareLinear,
     .answer = fourTexelsAnswer},
    {.name = "pcf",
     .what = "percentage-closer filtering",
     .shader = "shadow_map/filters/filter_pcf.glsl",
     .anchors = {"compare-pcf-pairs", "compare-pcf"},
     .params = {"pcf-radius"},
     .radiusTexels = [](const FilterParams& p) { return static_cast<double>(p.pcfRadius); },
     .interpolatesOneDepth = true,
     .answer = squareAnswer},
    {.name = "disc",
     .what = "random samples in a disc",
     .shader = "shadow_map/filters/filter_disc.glsl",
     .anchors = {"compare-disc"},
     .params = {"disc-radius", "samples", "noise"},
     .kernel = KernelForm::disc,
     .radiusTexels = [](const FilterParams& p) { return p.discRadius; },
     .answer = discAnswer},
    // Its kernel has no fixed radius: the fit leaves room for the penumbra, and the bias has to follow the receiver's plane.
    {.name = "pcss",
     .what = "percentage-closer soft shadows",
     .shader = "shadow_map/filters/filter_pcss.glsl",
     .anchors = {"compare-pcss"},
     .params = {"samples", "noise", "light-radius", "blocker-samples", "widest"},
     .kernel = KernelForm::penumbra,
     .radiusTexels = [](const FilterParams&) { return 1.0; },
     .sampling = gl::DepthSampling::depths,
     .searchesBlockers = true,
     .answer = softShadowAnswer},
    {.name = "vsm",
     .what = "variance of depths",
     .shader = "shadow_map/filters/filter_vsm.glsl",
     .anchors = {"compare-vsm"},
     .params = {"blur-radius", "mipmaps", "moment-format", "least-deviation", "bleed-reduction"},
     .kernel = KernelForm::square,
     .radiusTexels = momentRadius,
     .moments = &kVarianceMoments,
     .answer = momentAnswer},
    {.name = "esm",
     .what = "exponential of depths",
     .shader = "shadow_map/filters/filter_esm.glsl",
     .anchors = {"compare-esm"},
     .params = {"blur-radius", "mipmaps", "moment-format", "esm-exponent", "esm-logarithms", "exponent-limit"},
     .kernel = KernelForm::square,
     .radiusTexels = momentRadius,
     .moments = &kExponentialMoment,
     .answer = momentAnswer},
    {.name = "evsm",
     .what = "exponential variance",
     .shader = "shadow_map/filters/filter_evsm.glsl",
     .anchors = {"compare-evsm"},
     .params = {"blur-radius", "mipmaps", "moment-format", "least-deviation", "bleed-reduction", "evsm-moments",
                "evsm-exponent", "evsm-negative", "exponent-limit"},
     .kernel = KernelForm::square,
     .radiusTexels = momentRadius,
     .moments = &kExponentialVarianceMoments,
     .answer = momentAnswer},
    {.name = "msm",
     .what = "four moments of depths",
     .shader = "shadow_map/filters/filter_msm.glsl",
     .anchors = {"compare-msm"},
     .params = {"blur-radius", "mipmaps", "moment-format", "bleed-reduction", "msm-bias"},
     .kernel = KernelForm::square,
     .radiusTexels = momentRadius,
     .moments = &kFourMoments,
     .answer = momentAnswer},
};

} // namespace

std::span<const FilterInfo> filters() { return kFilters; }

const FilterInfo& filterInfo(FilterKind kind) { return kFilters[static_cast<std::size_t>(kind)]; }

FilterKind filterNamed(std::string_view name) {
    const auto* found = std::ranges::find(kFilters, name, &FilterInfo::name);
    if (found == std::end(kFilters)) throw Error(ExitStatus::bug, "there is no shadow map filter " + std::string(name));
    return static_cast<FilterKind>(found - std::begin(kFilters));
}

bool FilterInfo::reads(std::string_view param) const { return std::ranges::find(params, param) != params.end(); }

gl::DepthSampling depthSampling(const FilterParams& params, bool oneDepth) {
    const FilterInfo& filter = filterInfo(params.kind);
    return oneDepth && filter.interpolatesOneDepth ? gl::DepthSampling::compareLinear : filter.sampling;
}

bool FilterParams::usesMoments() const { return filterInfo(kind).moments != nullptr; }

bool FilterParams::usesDistances() const { return usesMoments() || filterInfo(kind).searchesBlockers; }

int FilterParams::kernelRadius() const { return static_cast<int>(std::ceil(filterInfo(kind).radiusTexels(*this))); }

double FilterParams::comparedRadius() const {
    const FilterInfo& filter = filterInfo(kind);
    return filter.moments ? filter.moments->comparedRadius(*this) : filter.radiusTexels(*this);
}

double lightReach(const scene::Light& light, const FilterParams& params) {
    if (light.type == scene::LightType::rect)
        return 0.5 * glm::length(light.edgeUWorld) + 0.5 * glm::length(light.edgeVWorld);
    return light.type == scene::LightType::sphere ? light.radius : params.lightRadius;
}

} // namespace shadowlab::shadow_map
