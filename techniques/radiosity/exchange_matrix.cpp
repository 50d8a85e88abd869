// SPDX-License-Identifier: MIT
#include "techniques/radiosity/exchange_matrix.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "techniques/radiosity/row_pieces.h"

namespace shadowlab::radiosity {

namespace {

/// sum_j d_i S_ij d_j / A_i: the row sums that S would have if it were scaled by `d`.
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

double largestDeviation(std::span<const double> sums, Closure closure) {
    double largest = 0;
    for (const double sum : sums)
        largest = std::max(largest, closure == Closure::closedRoom ? std::abs(sum - 1) : sum - 1);
    return largest;
}

double largestChange(const ExchangeMatrix& exchange, std::span<const double> d) {
    std::vector<double> ofRow(exchange.size(), 0.0);
    forRows(exchange.size(), [&](std::size_t i) {
        const std::span<const double> row = exchange.row(i);
        for (std::size_t j = 0; j < row.size(); ++j)
            if (row[j] != 0) ofRow[i] = std::max(ofRow[i], std::abs(d[i] * d[j] - 1));
    });
    return exchange.size() == 0 ? 0.0 : *std::ranges::max_element(ofRow);
}

} // namespace

void ExchangeMatrix::scale(std::span<const double> factors) {
    forRows(size_, [&](std::size_t i) {
        for (std::size_t j = 0; j < size_; ++j)
            values_[i * size_ + j] *= factors[i] * factors[j];
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
    constexpr double kWanted = 1e-12;  // so that energy, which the row sums bound, is kept far below 1e-10
    constexpr double kAccepted = 1e-6; // what row sums are promised to be
    constexpr int kMostPasses = 300; // each halves the deviation or nearly so; slow are walls that only see each other
    std::vector<double> d(exchange.size(), 1.0);
    std::vector<double> sums = scaledRowSums(exchange, areas, d);
    const double deviationBefore = largestDeviation(sums, closure);
    double deviation = deviationBefore;
    int passes = 0;
    for (; deviation > kWanted && passes < kMostPasses; ++passes) {
        for (std::size_t i = 0; i < d.size(); ++i) {
            if (sums[i] > 0) d[i] /= std::sqrt(sums[i]);
            if (closure == Closure::openScene) d[i] = std::min(d[i], 1.0);
        }
        sums = scaledRowSums(exchange, areas, d);
        deviation = largestDeviation(sums, closure);
    }
    if (!(deviation <= kAccepted)) return {std::move(exchange), false, 0.0, deviationBefore, passes};
    const double change = passes > 0 ? largestChange(exchange, d) : 0.0;
    if (passes > 0) exchange.scale(d);
    return {std::move(exchange), true, change, deviation, passes};
}

} // namespace shadowlab::radiosity
