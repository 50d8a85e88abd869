// SPDX-License-Identifier: MIT
#include "techniques/radiosity/exchange/hemicube_exchange.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/gl/debug.h"

namespace shadowlab::radiosity {

HemicubeExchange::HemicubeExchange(const std::vector<Patch>& patches, int side)
    : patches_(patches), hemicube_(side), exchange_(patches.size()) {
    hemicube_.setPatches(patches);
}

bool HemicubeExchange::advance(std::chrono::steady_clock::time_point deadline) {
    const gl::DebugGroup group("hemicubes");
    while (next_ < patches_.size()) {
        fill(next_++);
        if (std::chrono::steady_clock::now() >= deadline) break;
    }
    return next_ == patches_.size();
}

double HemicubeExchange::done() const {
    return patches_.empty() ? 1 : static_cast<double>(next_) / static_cast<double>(patches_.size());
}

ReciprocityGap HemicubeExchange::gap() const { return {largestGap_, sums_ > 0 ? gaps_ / sums_ : 0}; }

void HemicubeExchange::fill(std::size_t i) {
    const std::vector<double> factors = hemicube_.formFactors(patches_[i]);
    for (std::size_t j = 0; j < factors.size(); ++j) {
        if (j == i) continue; // a flat patch does not see itself
        const double there = patches_[i].area * factors[j];
        if (j > i) {
            if (there > 0) exchange_.set(i, j, there);
            continue;
        }
        const double back = exchange_(j, i); // patch j was the centre of an earlier hemicube
        if (there == back) {
            sums_ += 2 * there;
            continue;
        }
        exchange_.set(i, j, (there + back) / 2);
        largestGap_ = std::max(largestGap_, std::abs(there - back) / (patches_[i].area + patches_[j].area));
        gaps_ += std::abs(there - back);
        sums_ += there + back;
    }
}

} // namespace shadowlab::radiosity
