// The moments around a point, averaged and rounded as make_moments.frag and average_column.frag do, for the probe.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <glm/gtc/packing.hpp>

#include "techniques/probed/map_probe.h"
#include "techniques/shadow_map/bias/biases.h"
#include "techniques/shadow_map/filters/filters.h"
#include "techniques/shadow_map/filters/moment_filters.h"
#include "techniques/shadow_map/filters/moment_maps.h"
#include "techniques/shadow_map/probe/map_probe.h"

namespace shadowlab::shadow_map {

namespace {

/// The number as it is after it was stored in a texture of that format.
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

/// The moments of one layer, computed for a texel when they are first needed.
class MomentTexels {
public:
    explicit MomentTexels(const ComparedPoint& point)
        : point_(point), viewFromClip_(point.maps.lightViewFromLightClip(point.layer)) {}

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
            known->second = filterInfo(point_.filter.kind).moments->ofDepth(point_.filter, momentDepth(uv, depth));
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
    dmat4 viewFromClip_;
    std::map<std::pair<int, int>, dvec4> texels_;
};

} // namespace

FilterAnswer momentAnswer(const ComparedPoint& point) {
    const ProbedLayer map(point);
    MomentTexels texels(point);
    FilterAnswer answer;
    MapProbe::Moments& result = answer.moments.emplace();
    const dvec2 uv = map.place().uv;
    const bool isOutside = glm::any(glm::greaterThan(glm::abs(uv - 0.5), dvec2(0.5)));
    if (point.params.border == ShadowMapParams::Border::edge || !isOutside) {
        // Moments are interpolated between the centres of texels, so the point's own depth is compared, at its own place.
        const bool comparesAtCentres = biasInfo(point.params.bias.mode).comparesAtCentres;
        result.depth =
            texels.momentDepth(uv, comparesAtCentres ? std::min(map.place().depth, 1.0) : map.depthAt(dvec2(0.0)));
        filterInfo(point.filter.kind).moments->answer(point.filter, texels.at(uv), result);
    }
    answer.visibility = result.visibility;
    return answer;
}

} // namespace shadowlab::shadow_map
