// SPDX-License-Identifier: MIT
#include "app/judge/metrics/boundary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::judge {

namespace {

// Squared distances in half pixels. A picture of 16384 pixels a side keeps them below 2^31.
using Squared = std::int32_t;
constexpr Squared kFar = std::numeric_limits<Squared>::max();

constexpr double kCoreTexels = 1.5;

/// For each place of a line, the least of (place - i)^2 + values[i]: the lower envelope of parabolas, one standing on
/// each value that is not far. Felzenszwalb and Huttenlocher, "Distance Transforms of Sampled Functions", Theory of
/// Computing 8, 2012. Linear in the length of the line.
class Envelope {
public:
    void transform(std::vector<Squared>& values) {
        const auto count = static_cast<int>(values.size());
        roots_.clear();
        starts_.clear();
        for (int i = 0; i < count; ++i) {
            if (values[at(i)] == kFar) continue;
            double start = -std::numeric_limits<double>::infinity();
            while (!roots_.empty()) {
                start = crossing(values, roots_.back(), i);
                if (start > starts_.back()) break;
                roots_.pop_back(); // this one is below nowhere
                starts_.pop_back();
            }
            if (roots_.empty()) start = -std::numeric_limits<double>::infinity();
            roots_.push_back(i);
            starts_.push_back(start);
        }
        if (roots_.empty()) return;
        result_.resize(values.size());
        for (std::size_t k = 0, i = 0; i < values.size(); ++i) {
            while (k + 1 < roots_.size() && starts_[k + 1] < static_cast<double>(i))
                ++k;
            const Squared away = static_cast<Squared>(i) - roots_[k];
            result_[i] = away * away + values[at(roots_[k])];
        }
        values.swap(result_);
    }

private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    /// Where the parabola on q comes to lie below the one on p < q.
    static double crossing(const std::vector<Squared>& values, int p, int q) {
        const double dp = static_cast<double>(values[at(p)]) + double(p) * p;
        const double dq = static_cast<double>(values[at(q)]) + double(q) * q;
        return (dq - dp) / (2.0 * (q - p));
    }
    std::vector<int> roots_;
    std::vector<double> starts_;
    std::vector<Squared> result_;
};

/// Squared distance to the nearest edge, for every corner, edge and centre of the pixels: (2 width + 1) x (2 height + 1).
Grid<Squared> squaredDistances(const std::vector<BoundaryEdge>& edges, ivec2 size, const std::stop_token& stop = {}) {
    Grid<Squared> squared(2 * size.x + 1, 2 * size.y + 1, kFar);
    for (const BoundaryEdge& edge : edges)
        squared.at(edge.x, edge.y) = 0;
    // Down all columns, then along all rows. Strips of them, so that threads do not meet in one cache line.
    constexpr int kStrip = 16;
    const auto strips = [](int count) { return static_cast<std::size_t>((count + kStrip - 1) / kStrip); };
    const auto downColumns = [&](std::size_t strip) {
        Envelope envelope;
        std::vector<Squared> line(static_cast<std::size_t>(squared.height));
        const int first = static_cast<int>(strip) * kStrip;
        for (int x = first; x < std::min(first + kStrip, squared.width); ++x) {
            for (int y = 0; y < squared.height; ++y)
                line[static_cast<std::size_t>(y)] = squared.at(x, y);
            envelope.transform(line);
            for (int y = 0; y < squared.height; ++y)
                squared.at(x, y) = line[static_cast<std::size_t>(y)];
        }
    };
    const auto alongRows = [&](std::size_t strip) {
        Envelope envelope;
        std::vector<Squared> line;
        const int first = static_cast<int>(strip) * kStrip;
        for (int y = first; y < std::min(first + kStrip, squared.height); ++y) {
            const auto begin = squared.values.begin() + static_cast<std::ptrdiff_t>(squared.index(0, y));
            line.assign(begin, begin + squared.width);
            envelope.transform(line);
            std::ranges::copy(line, begin);
        }
    };
    trace::parallelFor(strips(squared.width), downColumns, stop);
    trace::parallelFor(strips(squared.height), alongRows, stop);
    return squared;
}

double pixels(Squared squaredHalves) { return 0.5 * std::sqrt(static_cast<double>(squaredHalves)); }

} // namespace

std::vector<BoundaryEdge> boundaryEdges(const Grid<Shade>& shades, const Grid<std::uint32_t>& receivers) {
    const auto differ = [&](std::size_t a, std::size_t b) {
        const Shade p = shades.values[a], q = shades.values[b];
        return ((p == Shade::lit && q == Shade::shadowed) || (p == Shade::shadowed && q == Shade::lit)) &&
               receivers.values[a] == receivers.values[b];
    };
    std::vector<BoundaryEdge> edges;
    for (int y = 0; y < shades.height; ++y)
        for (int x = 0; x < shades.width; ++x) {
            const std::size_t here = shades.index(x, y);
            if (x > 0 && differ(here - 1, here)) edges.emplace_back(2 * x, 2 * y + 1);
            if (y > 0 && differ(shades.index(x, y - 1), here)) edges.emplace_back(2 * x + 1, 2 * y);
        }
    return edges;
}

double lengthPx(const std::vector<BoundaryEdge>& edges) {
    return static_cast<double>(edges.size()) * glm::pi<double>() / 4.0;
}

Grid<float> distanceToBoundary(const std::vector<BoundaryEdge>& edges, ivec2 size, const std::stop_token& stop) {
    Grid<float> distances(size.x, size.y, std::numeric_limits<float>::infinity());
    if (edges.empty()) return distances;
    const Grid<Squared> squared = squaredDistances(edges, size, stop);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            distances.at(x, y) = static_cast<float>(pixels(squared.at(2 * x + 1, 2 * y + 1)));
    return distances;
}

std::optional<Displacement> displacement(const std::vector<BoundaryEdge>& truth,
                                         const std::vector<BoundaryEdge>& technique, ivec2 size) {
    if (truth.empty() || technique.empty()) return std::nullopt;
    std::vector<double> distances;
    distances.reserve(truth.size() + technique.size());
    const auto add = [&](const std::vector<BoundaryEdge>& from, const std::vector<BoundaryEdge>& to) {
        const Grid<Squared> squared = squaredDistances(to, size);
        for (const BoundaryEdge& edge : from)
            distances.push_back(pixels(squared.at(edge.x, edge.y)));
    };
    add(truth, technique);
    add(technique, truth);
    std::ranges::sort(distances);
    const double sum = std::accumulate(distances.begin(), distances.end(), 0.0);
    const auto last = static_cast<double>(distances.size() - 1);
    return Displacement{sum / static_cast<double>(distances.size()),
                        distances[static_cast<std::size_t>(std::ceil(0.95 * last))], distances.back()};
}

int coreErrors(const Grid<std::uint8_t>& wrong, const Grid<float>& distancePx,
               const std::optional<Grid<float>>& texelPx) {
    int count = 0;
    for (std::size_t i = 0; i < wrong.values.size(); ++i) {
        if (!wrong.values[i]) continue;
        const double texels = texelPx ? kCoreTexels * texelPx->values[i] : 0.0;
        count += distancePx.values[i] > std::max(kCorePx, texels);
    }
    return count;
}

} // namespace shadowlab::judge
