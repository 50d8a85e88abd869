// Computes the exchange areas of all pairs of patches by hemicubes, patch by patch, in slices of time.
//
// The hemicube of patch i covers patch j with other pixels than that of j covers i, so A_i F_ij and A_j F_ji differ, and energy
// would not be conserved. Both are replaced by their mean: reciprocity holds again, and independent errors shrink by sqrt(2). Row
// sums, which were 1 in a closed room, no longer are; scaledToClosure() in exchange_matrix.h corrects them.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>

#include "techniques/radiosity/exchange/exchange_matrix.h"
#include "techniques/radiosity/form_factors/hemicube.h"

namespace shadowlab::radiosity {

/// How much A_i F_ij and A_j F_ji differed before they were averaged.
struct ReciprocityGap {
    /// The largest |A_i F_ij - A_j F_ji| / (A_i + A_j): the error of a form factor between patches of equal size.
    double largest = 0;
    double share = 0; ///< the sum of |A_i F_ij - A_j F_ji|, as a share of the sum of A_i F_ij + A_j F_ji
};

class HemicubeExchange {
public:
    /// The patches must outlive this object. `side`: as in Hemicube.
    HemicubeExchange(const std::vector<Patch>& patches, int side);

    /// Continues until all is done (true) or the deadline has passed, but always by one patch. The numbers do not depend on
    /// deadlines. On the thread of the GL context that was current in the constructor.
    bool advance(std::chrono::steady_clock::time_point deadline);
    /// 0..1 of all patches.
    [[nodiscard]] double done() const;

    /// Complete when all is done; before that, A_i F_ij is not yet averaged where the hemicube of j has not been drawn.
    [[nodiscard]] const ExchangeMatrix& exchange() const { return exchange_; }
    [[nodiscard]] ExchangeMatrix take() { return std::move(exchange_); }
    /// Of the pairs whose two hemicubes are drawn.
    [[nodiscard]] ReciprocityGap gap() const;

private:
    void fill(std::size_t i);

    const std::vector<Patch>& patches_;
    Hemicube hemicube_;
    ExchangeMatrix exchange_;
    std::size_t next_ = 0; ///< patch
    double largestGap_ = 0, gaps_ = 0, sums_ = 0;
};

} // namespace shadowlab::radiosity
