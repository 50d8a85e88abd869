// The exchange areas of all pairs of patches: S_ij = A_i F_ij, in square metres.
//
// A_i is the area of patch i, F_ij the form factor from i to j: the share of the light that leaves i that reaches j. Reciprocity,
// A_i F_ij = A_j F_ji, says that S is symmetric. So S is stored, one number for both directions, and F_ij = S_ij / A_i obeys
// reciprocity by construction. In a closed room every row of F sums to 1; in an open scene the rest of the light escapes.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace shadowlab::radiosity {

/// Square and symmetric, in double. The whole square is stored, so that each row is contiguous: twice the memory of one half, but
/// a product with a vector reads memory in order.
class ExchangeMatrix {
public:
    /// All zero: no patch sees another.
    explicit ExchangeMatrix(std::size_t size) : size_(size), values_(size * size, 0.0) {}

    /// How many patches there are.
    [[nodiscard]] std::size_t size() const { return size_; }
    /// S_ij, m^2.
    [[nodiscard]] double operator()(std::size_t i, std::size_t j) const { return values_[i * size_ + j]; }
    /// Sets S_ij and S_ji, m^2, at least 0.
    void set(std::size_t i, std::size_t j, double exchangeArea) {
        values_[i * size_ + j] = exchangeArea;
        values_[j * size_ + i] = exchangeArea;
    }
    /// S_i0, S_i1 ..., m^2.
    [[nodiscard]] std::span<const double> row(std::size_t i) const { return {values_.data() + i * size_, size_}; }
    /// The memory of the numbers.
    [[nodiscard]] std::size_t bytes() const { return values_.size() * sizeof(double); }
    /// S_ij becomes factor(i, j) S_ij. factor(i, j) must equal factor(j, i) to the last bit, or S is no longer symmetric.
    void scale(const std::function<double(std::size_t, std::size_t)>& factor);

private:
    std::size_t size_;
    std::vector<double> values_;
};

/// Sum over j of F_ij, for every patch i. `areas` in m^2, one for each patch, here and below.
std::vector<double> rowSums(const ExchangeMatrix& exchange, std::span<const double> areas);

/// 1 - the row sum: the share of the light leaving a patch that reaches no patch. 0 in a closed room; negative where form factors
/// are wrong.
std::vector<double> closureDeficits(const ExchangeMatrix& exchange, std::span<const double> areas);

/// The largest |A_i F_ij - A_j F_ji|, relative to the larger of the two, with F as it is used: S_ij / A_i, rounded.
double reciprocityResidual(const ExchangeMatrix& exchange, std::span<const double> areas);

/// Calls work(0) ... work(size - 1), one call per row of a matrix, on several threads where the matrix is large enough. How rows
/// are divided among threads depends on the size of the matrix alone.
void forRows(std::size_t size, const std::function<void(std::size_t)>& work);

enum class Closure { closedRoom, openScene };

/// What `scaledToClosure` returns.
struct ScaledExchange {
    ExchangeMatrix exchange;
    bool isClosed = false;       ///< the row sums are as required, within 1e-6; else `exchange` is unchanged
    double largestChange = 0;    ///< the largest |new S_ij / old S_ij - 1|: an estimate of the errors before
    double largestDeviation = 0; ///< what is left: the largest |row sum - 1|; in an open scene, row sum - 1, at least 0
    int passes = 0;
};

/// Scales S, symmetrically, such that row sums become right, and reports how much that changed it. In a closed room all row sums
/// become 1: S_ij <- d_i d_j S_ij, with the symmetric iteration of R. Sinkhorn and P. Knopp, "Concerning Nonnegative Matrices and
/// Doubly Stochastic Matrices", Pacific Journal of Mathematics 1967, d_i <- d_i / sqrt(row sum i); the square root prevents
/// oscillation. A room for which no such scaling exists (a patch sees nothing) is returned unchanged, with isClosed false. In an
/// open scene only rows that sum to more than 1, which is physically impossible, are scaled down to 1 or a little less: with e_i
/// the larger of row sum i and 1, S_ij <- S_ij / max(e_i, e_j).
ScaledExchange scaledToClosure(ExchangeMatrix exchange, std::span<const double> areas, Closure closure);

} // namespace shadowlab::radiosity
