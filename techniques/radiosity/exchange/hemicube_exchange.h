// All exchange areas of a scene's patches by hemicubes, patch by patch, as long as there is time.
//
// Seen from patch i, patch j covers other pixels than i does seen from j, so A_i F_ij and A_j F_ji differ, and energy would be lost or
// made. Their mean is taken for both: reciprocity holds again, and errors that are independent become smaller by sqrt(2). Row
// sums, which were 1 in a closed room, are 1 no longer (scaledToClosure() in exchange_matrix.h sees to that).
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>

#include "techniques/radiosity/exchange/exchange_matrix.h"
#include "techniques/radiosity/form_factors/hemicube.h"

namespace shadowlab::radiosity {

/// How much A_i F_ij and A_j F_ji differed before their mean was taken.
struct ReciprocityGap {
    double largest =
        0; ///< |A_i F_ij - A_j F_ji| / (A_i + A_j), over all pairs: a form factor between two patches of one size errs so much
    double share = 0; ///< the sum of |A_i F_ij - A_j F_ji|, as a share of the sum of A_i F_ij + A_j F_ji
};

class HemicubeExchange {
public:
    /// The patches must live as long. `side` as Hemicube has it.
    HemicubeExchange(const std::vector<Patch>& patches, int side);

    /// Goes on until all is done (true) or the time has come, but always by one patch. The numbers are the same for any deadlines. On
    /// the thread of the GL context, which must be the one that was current in the constructor.
    bool advance(std::chrono::steady_clock::time_point deadline);
    /// 0..1 of all patches.
    [[nodiscard]] double done() const;

    /// Complete when all is done; until then A_i F_ij stands alone where patch j has not looked yet.
    [[nodiscard]] const ExchangeMatrix& exchange() const { return exchange_; }
    [[nodiscard]] ExchangeMatrix take() { return std::move(exchange_); }
    /// Of the pairs that have looked at each other.
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
