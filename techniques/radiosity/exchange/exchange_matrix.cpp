// SPDX-License-Identifier: MIT
#include "techniques/radiosity/exchange/exchange_matrix.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::radiosity {

namespace {

/// sum_j d_i S_ij d_j / A_i: the row sums of S scaled by `d`.
std::vector<double> scaledRowSums(const ExchangeMatrix& exchange, std::span<const double> areas,
                                  std::span<const double> d) {
    std::vector<double> sums(exchange.size());
    forRows(exchange.size(), [&](std::size_t i) {
        const std::span<const double> row = exchange.row(i);
        double sum = 0;
        for (std::size_t j = 0; j < row.size(); ++j)
            sum += row[j] * d[j];
        sums[i] = d[i] * sum / areas[i];
    });
    return sums;
}

double largestDeviation(std::span<const double> sums) {
    double largest = 0;
    for (const double sum : sums)
        largest = std::max(largest, std::abs(sum - 1));
    return largest;
}

using Factor = std::function<double(std::size_t, std::size_t)>;

double largestChange(const ExchangeMatrix& exchange, const Factor& factor) {
    std::vector<double> ofRow(exchange.size(), 0.0);
    forRows(exchange.size(), [&](std::size_t i) {
        const std::span<const double> row = exchange.row(i);
        for (std::size_t j = 0; j < row.size(); ++j)
            if (row[j] != 0) ofRow[i] = std::max(ofRow[i], std::abs(factor(i, j) - 1));
    });
    return exchange.size() == 0 ? 0.0 : *std::ranges::max_element(ofRow);
}

ScaledExchange scaledBy(ExchangeMatrix exchange, const Factor& factor, int passes) {
    const double change = largestChange(exchange, factor);
    if (change > 0) exchange.scale(factor);
    return {std::move(exchange), true, change, 0.0, passes};
}

ScaledExchange scaledToAtMostOne(ExchangeMatrix exchange, std::span<const double> areas) {
    std::vector<double> excess = rowSums(exchange, areas);
    for (double& sum : excess)
        sum = std::max(sum, 1.0);
    const auto factor = [&](std::size_t i, std::size_t j) { return 1 / std::max(excess[i], excess[j]); };
    ScaledExchange scaled = scaledBy(std::move(exchange), factor, 1);
    for (const double sum : rowSums(scaled.exchange, areas))
        scaled.largestDeviation = std::max(scaled.largestDeviation, sum - 1);
    return scaled;
}

ScaledExchange scaledToOne(ExchangeMatrix exchange, std::span<const double> areas) {
    constexpr double kWanted = 1e-12;  // so that energy, which the row sums bound, is conserved far below 1e-10
    constexpr double kAccepted = 1e-6; // the accuracy that is promised
    constexpr int kMostPasses = 300;   // each about halves the deviation; slowest where walls see only each other
    std::vector<double> d(exchange.size(), 1.0);
    std::vector<double> sums = scaledRowSums(exchange, areas, d);
    const double deviationBefore = largestDeviation(sums);
    double deviation = deviationBefore;
    int passes = 0;
    for (; deviation > kWanted && passes < kMostPasses; ++passes) {
        for (std::size_t i = 0; i < d.size(); ++i)
            if (sums[i] > 0) d[i] /= std::sqrt(sums[i]);
        sums = scaledRowSums(exchange, areas, d);
        deviation = largestDeviation(sums);
    }
    if (!(deviation <= kAccepted)) return {std::move(exchange), false, 0.0, deviationBefore, passes};
    const auto factor = [&](std::size_t i, std::size_t j) { return d[i] * d[j]; };
    ScaledExchange scaled = scaledBy(std::move(exchange), factor, passes);
    scaled.largestDeviation = deviation;
    return scaled;
}

} // namespace

void forRows(std::size_t size, const std::function<void(std::size_t)>& work) {
    // Some 50 microseconds of work each, about the cost of starting a thread; a small matrix is one piece and starts none.
    constexpr std::size_t kNumbersInPiece = 1 << 16;
    const std::size_t rows = std::max<std::size_t>(1, kNumbersInPiece / std::max<std::size_t>(1, size));
    const auto workOn = [&](std::size_t piece) {
        for (std::size_t i = piece * rows; i < std::min(size, (piece + 1) * rows); ++i)
            work(i);
    };
    if (size <= rows)
        workOn(0); // a single piece: no thread, not even the question how many there are
    else
        trace::parallelFor((size + rows - 1) / rows, workOn);
}

void ExchangeMatrix::scale(const std::function<double(std::size_t, std::size_t)>& factor) {
    forRows(size_, [&](std::size_t i) {
        for (std::size_t j = 0; j < size_; ++j)
            values_[i * size_ + j] *= factor(i, j);
    });
}

std::vector<double> rowSums(const ExchangeMatrix& exchange, std::span<const double> areas) {
    return scaledRowSums(exchange, areas, std::vector<double>(exchange.size(), 1.0));
}

std::vector<double> closureDeficits(const ExchangeMatrix& exchange, std::span<const double> areas) {
    std::vector<double> deficits = rowSums(exchange, areas);
    for (double& value : deficits)
        value = 1 - value;
    return deficits;
}

double reciprocityResidual(const ExchangeMatrix& exchange, std::span<const double> areas) {
    double largest = 0;
    for (std::size_t i = 0; i < exchange.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double there = areas[i] * (exchange(i, j) / areas[i]);
            const double back = areas[j] * (exchange(j, i) / areas[j]);
            if (there != back) largest = std::max(largest, std::abs(there - back) / std::max(there, back));
        }
    return largest;
}

ScaledExchange scaledToClosure(ExchangeMatrix exchange, std::span<const double> areas, Closure closure) {
    return closure == Closure::closedRoom ? scaledToOne(std::move(exchange), areas)
                                          : scaledToAtMostOne(std::move(exchange), areas);
}

} // namespace shadowlab::radiosity
