// SPDX-License-Identifier: MIT
#include "app/judge/metrics/flips.h"

#include <utility>

namespace shadowlab::judge {

void ExcessFlips::addFrame(std::vector<std::uint8_t> lit, std::vector<std::uint8_t> truthLit, double boundaryPx) {
    if (!lit_.empty()) {
        for (std::size_t i = 0; i < lit.size(); ++i)
            flips_ += lit[i] != lit_[i] && truthLit[i] == truthLit_[i];
        boundaryPx_ += boundaryPx;
    }
    lit_ = std::move(lit);
    truthLit_ = std::move(truthLit);
}

std::optional<double> ExcessFlips::rate() const {
    if (boundaryPx_ <= 0) return std::nullopt;
    return static_cast<double>(flips_) / boundaryPx_;
}

} // namespace shadowlab::judge
