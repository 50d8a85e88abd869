// What the filters read that average: the moments around a point, as the format keeps them, and the bound that follows.
// The shaders are filter_vsm.glsl to filter_msm.glsl, and make_moments.frag.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <glm/gtc/packing.hpp>

#include "techniques/shadow_map/filters/moment_maps.h"
#include "techniques/shadow_map/probe/map_probe.h"

namespace shadowlab::shadow_map {

namespace {

using Kind = FilterParams::Kind;
using Bound = MapProbe::Moments::Bound;

/// As a texture of that format keeps a number.
double asKept(FilterParams::MomentFormat format, double value) {
    const double largest = std::numeric_limits<float>::max();
    if (std::abs(value) > largest) return std::copysign(std::numeric_limits<double>::infinity(), value);
    const auto single = static_cast<float>(value);
    if (format == FilterParams::MomentFormat::float32) return static_cast<double>(single);
    return static_cast<double>(glm::unpackHalf1x16(glm::packHalf1x16(single)));
}

dvec4 asKept(FilterParams::MomentFormat format, dvec4 values) {
    for (int i = 0; i < 4; ++i)
        values[i] = asKept(format, values[i]);
    return values;
}

/// The moments of one layer, made where they are asked for.
class MomentTexels {
public:
    explicit MomentTexels(const ComparedPoint& point)
        : point_(point), used_(exponents(point.filter)), viewFromClip_(point.maps.lightViewFromLightClip(point.layer)) {
    }

    /// From -1 at the map's near side to 1 at its far side.
    [[nodiscard]] double momentDepth(const dvec2& uv, double depth) const {
        const dvec4 place = viewFromClip_ * dvec4(dvec3(uv, depth) * 2.0 - 1.0, 1.0);
        const LightMaps& maps = point_.maps;
        return (-place.z / place.w - maps.nearest) * (2.0 / (maps.farthest - maps.nearest)) - 1.0;
    }

    /// Averaged over the kernel, and interpolated between the four texels around.
    dvec4 at(const dvec2& uv) {
        const dvec2 texel = uv * static_cast<double>(point_.params.resolution) - 0.5;
        const ivec2 lower(glm::floor(texel));
        const dvec2 share = texel - glm::floor(texel);
        std::array<dvec4, 4> four{};
        std::array<double, 4> weights{};
        for (int i = 0; i < 4; ++i) {
            const dvec2 corner(i & 1, i >> 1);
            const dvec2 weight = glm::mix(1.0 - share, share, corner);
            four[static_cast<std::size_t>(i)] = averaged(lower + ivec2(corner));
            weights[static_cast<std::size_t>(i)] = weight.x * weight.y;
        }
        return mean(four, weights);
    }

private:
    [[nodiscard]] dvec4 ofDepth(double z) const {
        const double positive = std::exp(used_.evsm.x * z), negative = -std::exp(-used_.evsm.y * z);
        const double exponent = used_.esm * (0.5 * z + 0.5);
        switch (point_.filter.kind) {
        case Kind::esm: return dvec4(averagesLogarithms(point_.filter) ? exponent : std::exp(exponent), 0, 0, 0);
        case Kind::evsm: return {positive, positive * positive, negative, negative * negative};
        case Kind::msm: return {z, z * z, z * z * z, z * z * z * z};
        default: return {z, z * z, 0, 0};
        }
    }

    [[nodiscard]] dvec4 mean(std::span<const dvec4> values, std::span<const double> weights) const {
        dvec4 sum(0.0);
        if (!averagesLogarithms(point_.filter)) {
            for (std::size_t i = 0; i < values.size(); ++i)
                if (weights[i] > 0) sum += weights[i] * values[i];
            return sum;
        }
        double largest = -std::numeric_limits<double>::infinity();
        for (const dvec4& value : values)
            largest = std::max(largest, value.x);
        for (std::size_t i = 0; i < values.size(); ++i)
            sum.x += weights[i] * std::exp(values[i].x - largest);
        return dvec4(largest + std::log(sum.x), 0, 0, 0);
    }

    dvec4 ofTexel(const ivec2& texel) {
        const auto [known, isNew] = texels_.try_emplace({texel.x, texel.y});
        if (isNew) {
            const dvec2 uv = (dvec2(texel) + 0.5) / static_cast<double>(point_.params.resolution);
            const double depth = shadow_map::asKept(point_.params.depthFormat, point_.depths.at(texel).stored);
            known->second = ofDepth(momentDepth(uv, depth));
        }
        return known->second;
    }

    /// Along rows first, then along columns; both are kept in textures of the format. Beyond the border its texels go on.
    dvec4 averaged(const ivec2& centre) {
        const int radius = point_.filter.blurRadius, last = point_.params.resolution - 1;
        const std::vector<double> weights(static_cast<std::size_t>(2 * radius + 1), 1.0 / (2 * radius + 1));
        const ivec2 middle = glm::clamp(centre, ivec2(0), ivec2(last));
        std::vector<dvec4> rows;
        for (int dy = -radius; dy <= radius; ++dy) {
            std::vector<dvec4> row;
            for (int dx = -radius; dx <= radius; ++dx)
                row.push_back(ofTexel(glm::clamp(middle + ivec2(dx, dy), ivec2(0), ivec2(last))));
            rows.push_back(asKept(point_.filter.momentFormat, mean(row, weights)));
        }
        return asKept(point_.filter.momentFormat, mean(rows, weights));
    }

    const ComparedPoint& point_;
    Exponents used_;
    dmat4 viewFromClip_;
    std::map<std::pair<int, int>, dvec4> texels_;
};

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

} // namespace

MapProbe::Moments momentsOf(const ComparedPoint& point) {
    const AskedMap map(point);
    const FilterParams& filter = point.filter;
    MomentTexels texels(point);
    MapProbe::Moments result;
    const dvec2 uv = map.place().uv;
    if (point.params.border == ShadowMapParams::Border::lit &&
        glm::any(glm::greaterThan(glm::abs(uv - 0.5), dvec2(0.5))))
        return result;
    // Moments are interpolated between the centres of texels: they are asked for the point itself.
    const bool comparesAtCentres = point.params.bias.mode == BiasParams::Mode::adaptive;
    result.depth =
        texels.momentDepth(uv, comparesAtCentres ? std::min(map.place().depth, 1.0) : map.depthAt(dvec2(0.0)));
    const double z = result.depth, leastDeviation = 2 * filter.leastDeviation;
    const dvec4 m = texels.at(uv);
    const Exponents used = exponents(filter);
    using std::exp;
    switch (filter.kind) {
    case Kind::esm: {
        const double exponent = used.esm * (0.5 * z + 0.5);
        const bool logarithms = averagesLogarithms(filter);
        result.read = {{logarithms ? "log of the mean of exp(c d)" : "mean of exp(c d)", m.x}, {"c z", exponent}};
        result.unreduced = logarithms ? exp(m.x - exponent) : m.x * exp(-exponent);
        result.visibility = glm::clamp(result.unreduced, 0.0, 1.0);
        result.isFinite = std::isfinite(m.x) && std::isfinite(result.unreduced);
        return result;
    }
    case Kind::evsm: {
        const bool four = filter.evsmMoments == FilterParams::EvsmMoments::four;
        const double positive = exp(used.evsm.x * z), negative = -exp(-used.evsm.y * z);
        result.read = {{"mean of exp(c d)", m.x}, {"mean of exp(c d)^2", m.y}};
        result.bounds.push_back(
            boundOf("exp(c z)", positive, m.x, m.y, std::pow(leastDeviation * used.evsm.x * positive, 2)));
        if (four) {
            result.read.insert(result.read.end(), {{"mean of -exp(-c d)", m.z}, {"mean of exp(-c d)^2", m.w}});
            result.bounds.push_back(
                boundOf("-exp(-c z)", negative, m.z, m.w, std::pow(leastDeviation * used.evsm.y * negative, 2)));
        }
        break;
    }
    case Kind::msm: {
        const double share = msmBias(filter);
        const dvec4 mended = glm::mix(m, dvec4(0, 0.375, 0, 0.375), share);
        result.read = {{"mean of d", m.x}, {"mean of d^2", m.y}, {"mean of d^3", m.z}, {"mean of d^4", m.w}};
        result.bounds.push_back(
            {"z", z, mended.x, mended.y - mended.x * mended.x, hamburgerVisibility(mended, z) / (1 - share)});
        break;
    }
    default:
        result.read = {{"mean of d", m.x}, {"mean of d^2", m.y}};
        result.bounds.push_back(boundOf("z", z, m.x, m.y, leastDeviation * leastDeviation));
    }
    for (const Bound& bound : result.bounds) {
        result.unreduced = std::min(result.unreduced, bound.visibility);
        result.isFinite = result.isFinite && std::isfinite(bound.mean) && std::isfinite(bound.variance) &&
                          std::isfinite(bound.visibility);
    }
    result.visibility = withoutBleeding(result.unreduced, filter.bleedReduction);
    return result;
}

} // namespace shadowlab::shadow_map
