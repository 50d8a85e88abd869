// SPDX-License-Identifier: MIT
#include "app/judge/metrics/image_metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "app/judge/grid.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::judge {

namespace {

constexpr int kWindow = 11;
constexpr double kDeviation = 1.5;
constexpr double kC1 = 0.01 * 255 * 0.01 * 255, kC2 = 0.03 * 255 * 0.03 * 255;

/// The Gaussian along one axis, of sum one.
std::vector<double> weights(int length) {
    std::vector<double> weights(static_cast<std::size_t>(length));
    for (int i = 0; i < length; ++i) {
        const double away = (i - (length - 1) / 2.0) / kDeviation;
        weights[static_cast<std::size_t>(i)] = std::exp(-0.5 * away * away);
    }
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (double& weight : weights)
        weight /= sum;
    return weights;
}

Grid<double> luma(const image::Image& picture) {
    Grid<double> values(picture.width, picture.height);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const image::Color8 c = picture.at(x, y);
            values.at(x, y) = 0.299 * c.r + 0.587 * c.g + 0.114 * c.b;
        }
    return values;
}

/// What is computed of the two pictures in a window: weighted means of a, b, a a, b b and a b.
using Moments = std::array<double, 5>;

/// The index of similarity of one window: luminance, and contrast with structure.
double similarity(const Moments& m) {
    const double varianceA = m[2] - m[0] * m[0], varianceB = m[3] - m[1] * m[1], covariance = m[4] - m[0] * m[1];
    return (2 * m[0] * m[1] + kC1) * (2 * covariance + kC2) /
           ((m[0] * m[0] + m[1] * m[1] + kC1) * (varianceA + varianceB + kC2));
}

} // namespace

double psnr(std::span<const float> a, std::span<const float> b) {
    double squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        squares += (double(a[i]) - b[i]) * (double(a[i]) - b[i]);
    if (squares == 0) return std::numeric_limits<double>::infinity();
    return -10.0 * std::log10(squares / static_cast<double>(a.size()));
}

double ssim(const image::Image& a, const image::Image& b) {
    const Grid<double> lumaA = luma(a), lumaB = luma(b);
    const std::vector<double> across = weights(std::min(kWindow, a.width)), down = weights(std::min(kWindow, a.height));
    const int columns = a.width - static_cast<int>(across.size()) + 1;
    const int rows = a.height - static_cast<int>(down.size()) + 1;
    std::vector<double> rowSums(static_cast<std::size_t>(rows));
    // A window is the product of two Gaussians: first down each column, then along the row of the result.
    trace::parallelFor(static_cast<std::size_t>(rows), [&](std::size_t row) {
        std::vector<Moments> columnMoments(static_cast<std::size_t>(a.width), Moments{});
        for (std::size_t j = 0; j < down.size(); ++j)
            for (int x = 0; x < a.width; ++x) {
                const int y = static_cast<int>(row + j);
                const double p = lumaA.at(x, y), q = lumaB.at(x, y);
                const Moments of = {p, q, p * p, q * q, p * q};
                for (std::size_t k = 0; k < of.size(); ++k)
                    columnMoments[static_cast<std::size_t>(x)][k] += down[j] * of[k];
            }
        double sum = 0;
        for (std::size_t x = 0; x < static_cast<std::size_t>(columns); ++x) {
            Moments window{};
            for (std::size_t i = 0; i < across.size(); ++i)
                for (std::size_t k = 0; k < window.size(); ++k)
                    window[k] += across[i] * columnMoments[x + i][k];
            sum += similarity(window);
        }
        rowSums[row] = sum;
    });
    return std::accumulate(rowSums.begin(), rowSums.end(), 0.0) / (double(rows) * columns);
}

} // namespace shadowlab::judge
