// The four filters of averaged moments on the processor, in double: what filter_vsm.glsl to filter_msm.glsl and moments_of_*.glsl
// compute.
// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/filters/moment_filters.h"

#include <algorithm>
#include <cmath>

#include "techniques/probed/map_probe.h"
#include "techniques/shadow_map/filters/moment_maps.h"

namespace shadowlab::shadow_map {

namespace {

using Bound = MapProbe::Moments::Bound;

/// Chebyshev's inequality, one-sided (Cantelli).
Bound boundOf(std::string of, double compared, double mean, double meanSquare, double leastVariance) {
    Bound bound{std::move(of), compared, mean, std::max(meanSquare - mean * mean, leastVariance), 1};
    const double beyond = compared - mean;
    if (compared > mean) bound.visibility = bound.variance / (bound.variance + beyond * beyond);
    return bound;
}

/// Hamburger's moment problem: 1 less the weights of the depths before d, of the distribution on three depths, d being one,
/// that has these moments. The other two are the roots of the polynomial q with (1, d, d^2) as its solution.
double hamburgerVisibility(const dvec4& m, double d) {
    const dmat3 hankel(dvec3(1, m.x, m.y), dvec3(m.x, m.y, m.z), dvec3(m.y, m.z, m.w));
    const dvec3 q = glm::inverse(hankel) * dvec3(1, d, d * d);
    const double root = std::sqrt(std::max(q.y * q.y - 4 * q.z * q.x, 0.0));
    const double sum = q.y + std::copysign(root, q.y);
    const double one = glm::clamp(-0.5 * sum / q.z, -1e6, 1e6), other = -2 * q.x / sum;
    const double nearer = std::min(one, other), farther = std::max(one, other);
    if (d <= nearer) return 1;
    const auto weight = [&](double of, double a, double b) {
        return (m.y - m.x * (a + b) + a * b) / ((of - a) * (of - b));
    };
    if (d <= farther) return 1 - glm::clamp(weight(nearer, d, farther), 0.0, 1.0);
    return glm::clamp(weight(d, nearer, farther), 0.0, 1.0);
}

/// What is no more lit than the reduction is dark.
double withoutBleeding(double visibility, double reduction) {
    return glm::clamp((visibility - reduction) / (1 - reduction), 0.0, 1.0);
}

/// The least of the bounds, less the light that bleeds through.
void applyBounds(const FilterParams& filter, MapProbe::Moments& result) {
    for (const Bound& bound : result.bounds) {
        result.unreduced = std::min(result.unreduced, bound.visibility);
        result.isFinite = result.isFinite && std::isfinite(bound.mean) && std::isfinite(bound.variance) &&
                          std::isfinite(bound.visibility);
    }
    result.visibility = withoutBleeding(result.unreduced, filter.bleedReduction);
}

/// `least-deviation` is a share of the map's range, and depths from -1 to 1 have a range of 2.
double leastDeviation(const FilterParams& filter) { return 2 * filter.leastDeviation; }

double noRadiusForBias(const FilterParams&) { return 0; } // a point on a plane is at its mean depth, and that is lit

// These two take one end of a plane that slants within the blur for something before the other end: a lit floor would be darkened
// to 0.7. A bias as for a comparison of that radius is too much; what serves a single comparison serves 3 x 3 texels.
double blurRadiusForBias(const FilterParams& filter) { return std::max(filter.blurRadius - 1, 0); }

dvec4 depthAndSquare(const FilterParams&, double z) { return {z, z * z, 0, 0}; }

void varianceAnswer(const FilterParams& filter, const dvec4& m, MapProbe::Moments& result) {
    const double least = leastDeviation(filter);
    result.read = {{"mean of d", m.x}, {"mean of d^2", m.y}};
    result.bounds.push_back(boundOf("z", result.depth, m.x, m.y, least * least));
    applyBounds(filter, result);
}

dvec4 exponentialOf(const FilterParams& filter, double z) {
    const double exponent = exponents(filter).esm * (0.5 * z + 0.5);
    return {averagesLogarithms(filter) ? exponent : std::exp(exponent), 0, 0, 0};
}

void exponentialAnswer(const FilterParams& filter, const dvec4& m, MapProbe::Moments& result) {
    const double exponent = exponents(filter).esm * (0.5 * result.depth + 0.5);
    const bool logarithms = averagesLogarithms(filter);
    result.read = {{logarithms ? "log of the mean of exp(c d)" : "mean of exp(c d)", m.x}, {"c z", exponent}};
    result.unreduced = logarithms ? std::exp(m.x - exponent) : m.x * std::exp(-exponent);
    result.visibility = glm::clamp(result.unreduced, 0.0, 1.0);
    result.isFinite = std::isfinite(m.x) && std::isfinite(result.unreduced);
}

bool hasNegativeExponential(const FilterParams& filter) {
    return filter.evsmMoments == FilterParams::EvsmMoments::four;
}

dvec4 twoExponentialsOf(const FilterParams& filter, double z) {
    const dvec2 used = exponents(filter).evsm;
    const double positive = std::exp(used.x * z), negative = -std::exp(-used.y * z);
    return {positive, positive * positive, negative, negative * negative};
}

void exponentialVarianceAnswer(const FilterParams& filter, const dvec4& m, MapProbe::Moments& result) {
    const dvec2 used = exponents(filter).evsm;
    const double z = result.depth, least = leastDeviation(filter);
    const double positive = std::exp(used.x * z), negative = -std::exp(-used.y * z);
    result.read = {{"mean of exp(c d)", m.x}, {"mean of exp(c d)^2", m.y}};
    // A deviation s of z is one of s times the derivative.
    result.bounds.push_back(boundOf("exp(c z)", positive, m.x, m.y, std::pow(least * used.x * positive, 2)));
    if (hasNegativeExponential(filter)) {
        result.read.insert(result.read.end(), {{"mean of -exp(-c d)", m.z}, {"mean of exp(-c d)^2", m.w}});
        result.bounds.push_back(boundOf("-exp(-c z)", negative, m.z, m.w, std::pow(least * used.y * negative, 2)));
    }
    applyBounds(filter, result);
}

dvec4 fourPowers(const FilterParams&, double z) { return {z, z * z, z * z * z, z * z * z * z}; }

void fourMomentsAnswer(const FilterParams& filter, const dvec4& m, MapProbe::Moments& result) {
    const double share = msmBias(filter), z = result.depth;
    const dvec4 possible = glm::mix(m, dvec4(0, 0.375, 0, 0.375), share);
    result.read = {{"mean of d", m.x}, {"mean of d^2", m.y}, {"mean of d^3", m.z}, {"mean of d^4", m.w}};
    result.bounds.push_back(
        {"z", z, possible.x, possible.y - possible.x * possible.x, hamburgerVisibility(possible, z) / (1 - share)});
    applyBounds(filter, result);
}

} // namespace

const MomentFilter kVarianceMoments{"shadow_map/moments/moments_of_vsm.glsl", [](const FilterParams&) { return 2; },
                                    noRadiusForBias, depthAndSquare, varianceAnswer};

const MomentFilter kExponentialMoment{"shadow_map/moments/moments_of_esm.glsl", [](const FilterParams&) { return 1; },
                                      noRadiusForBias, exponentialOf, exponentialAnswer};

const MomentFilter kExponentialVarianceMoments{"shadow_map/moments/moments_of_evsm.glsl",
                                               [](const FilterParams& p) { return hasNegativeExponential(p) ? 4 : 2; },
                                               blurRadiusForBias, twoExponentialsOf, exponentialVarianceAnswer};

const MomentFilter kFourMoments{"shadow_map/moments/moments_of_msm.glsl", [](const FilterParams&) { return 4; },
                                blurRadiusForBias, fourPowers, fourMomentsAnswer};

} // namespace shadowlab::shadow_map
