// SPDX-License-Identifier: MIT
#include "techniques/radiosity/exchange/exchange_builder.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::radiosity {

ExchangeBuilder::ExchangeBuilder(const Faces& faces, const std::vector<Patch>& patches, const Occlusion& occlusion,
                                 double linesPerPatch, std::optional<KnownExchange> known)
    : faces_(faces), patches_(patches), occlusion_(occlusion), linesPerPatch_(linesPerPatch), known_(known),
      exchange_(patches.size()), rows_(patches.size()) {
    for (std::size_t face = 0; face <= faces.all.size(); ++face)
        firstOfFace_.push_back(static_cast<std::size_t>(
            std::ranges::lower_bound(patches, face, {}, [](const Patch& p) { return std::size_t{p.face}; }) -
            patches.begin()));
}

bool ExchangeBuilder::advance(std::chrono::steady_clock::time_point deadline) {
    next_ = trace::parallelUntil(deadline, next_, patches_.size(), [&](std::size_t i) { fill(i); });
    return next_ == patches_.size();
}

double ExchangeBuilder::done() const {
    if (patches_.empty()) return 1;
    const double left = 1 - static_cast<double>(next_) / static_cast<double>(patches_.size());
    return 1 - left * left; // row i holds the pairs with later patches: rows get shorter
}

void ExchangeBuilder::fill(std::size_t i) {
    const Patch& patch = patches_[i];
    // Patches of one face lie in one plane and exchange nothing.
    for (std::size_t face = patch.face + 1; face < faces_.all.size(); ++face) {
        const Polygon& polygon = faces_.all[face].polygon;
        const std::size_t first = firstOfFace_[face], end = firstOfFace_[face + 1];
        if (first == end) continue; // all its patches were left out
        if (isBehind(patch.plane(), polygon, 0) || isBehind(patches_[first].plane(), patch.polygon, 0)) {
            rows_[i].counts.ofKind[0] += end - first;
            continue;
        }
        std::optional<Blockers> blockers; // needed only if a pair is new
        for (std::size_t j = first; j < end; ++j) {
            const bool isKnown =
                known_ && known_->from[i] != KnownExchange::kNew && known_->from[j] != KnownExchange::kNew;
            if (!isKnown && !blockers) blockers = occlusion_.between(patch.polygon, polygon);
            const VisibleExchange exchange =
                isKnown ? knownExchange(i, j)
                        : visibleExchange(patch, patches_[j], occlusion_, *blockers, linesPerPatch_);
            ++rows_[i].counts.ofKind[static_cast<std::size_t>(exchange.kind)];
            if (exchange.area > 0) exchange_.set(i, j, exchange.area);
            if (exchange.kind == VisibleExchange::Kind::partial)
                rows_[i].uncertain.push_back({static_cast<std::uint32_t>(j), static_cast<float>(exchange.error)});
        }
    }
}

VisibleExchange ExchangeBuilder::knownExchange(std::size_t i, std::size_t j) const {
    using Kind = VisibleExchange::Kind;
    const std::uint32_t row = known_->from[i],
                        patch = known_->from[j]; // their order has not changed, so i is still the row
    const std::vector<Uncertain>& uncertain = known_->builder.rows_[row].uncertain;
    const double area = known_->exchange(row, patch);
    const auto found = std::ranges::lower_bound(uncertain, patch, {}, &Uncertain::patch);
    if (found != uncertain.end() && found->patch == patch) return {Kind::partial, area, double{found->error}};
    if (area > 0) return {Kind::full, area, 0};
    const bool faceAway =
        isBehind(patches_[i].plane(), patches_[j].polygon, 0) || isBehind(patches_[j].plane(), patches_[i].polygon, 0);
    return {faceAway ? Kind::none : Kind::hidden, 0, 0};
}

ExchangeCounts ExchangeBuilder::counts() const {
    ExchangeCounts sum;
    for (const Row& row : rows_)
        for (std::size_t kind = 0; kind < sum.ofKind.size(); ++kind)
            sum.ofKind[kind] += row.counts.ofKind[kind];
    return sum;
}

std::vector<double> ExchangeBuilder::rowDeviations() const {
    std::vector<double> squares(patches_.size(), 0.0);
    for (std::size_t i = 0; i < rows_.size(); ++i)
        for (const Uncertain& one : rows_[i].uncertain) {
            const double square = static_cast<double>(one.error) * static_cast<double>(one.error);
            squares[i] += square;
            squares[one.patch] += square;
        }
    for (std::size_t i = 0; i < squares.size(); ++i)
        squares[i] = std::sqrt(squares[i]) / patches_[i].area;
    return squares;
}

} // namespace shadowlab::radiosity
