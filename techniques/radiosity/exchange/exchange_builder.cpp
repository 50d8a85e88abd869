// SPDX-License-Identifier: MIT
#include "techniques/radiosity/exchange/exchange_builder.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::radiosity {

namespace {

// A large patch may see a thousand others in part, and its row may take a third of a second, far more than a slice; so many of them take
// some milliseconds. Each piece has a list, of 24 bytes if it is empty: with fewer patches in a piece these would be a tenth of
// kBytesPerPair (patch_memory.h).
constexpr std::size_t kPatchesPerPiece = 64;

} // namespace

ExchangeBuilder::ExchangeBuilder(const Faces& faces, const std::vector<Patch>& patches, const Occlusion& occlusion,
                                 double linesPerPatch, std::optional<KnownExchange> known)
    : faces_(faces), patches_(patches), occlusion_(occlusion), linesPerPatch_(linesPerPatch), known_(known),
      exchange_(patches.size()), piecesPerRow_((patches.size() + kPatchesPerPiece - 1) / kPatchesPerPiece),
      uncertain_(patches.size() * piecesPerRow_) {
    for (std::size_t face = 0; face <= faces.all.size(); ++face)
        firstOfFace_.push_back(static_cast<std::size_t>(
            std::ranges::lower_bound(patches, face, {}, [](const Patch& p) { return std::size_t{p.face}; }) -
            patches.begin()));
}

bool ExchangeBuilder::advance(std::chrono::steady_clock::time_point deadline) {
    next_ = trace::parallelUntil(deadline, next_, uncertain_.size(), [&](std::size_t piece) { fill(piece); });
    return next_ == uncertain_.size();
}

double ExchangeBuilder::done() const {
    if (uncertain_.empty()) return 1;
    const double left = 1 - static_cast<double>(next_) / static_cast<double>(uncertain_.size());
    return 1 - left * left; // row i holds the pairs with later patches: rows get shorter
}

std::size_t ExchangeBuilder::pieceOf(std::size_t row, std::size_t patch) const { return row * piecesPerRow_ + patch / kPatchesPerPiece; }

void ExchangeBuilder::fill(std::size_t piece) {
    const std::size_t i = piece / piecesPerRow_, begin = piece % piecesPerRow_ * kPatchesPerPiece;
    const std::size_t last = std::min(begin + kPatchesPerPiece, patches_.size());
    ExchangeCounts counts;
    const Patch& patch = patches_[i];
    // Patches of one face lie in one plane and exchange nothing.
    for (std::size_t first = std::max(begin, firstOfFace_[patch.face + 1]), end = 0; first < last; first = end) {
        const std::uint32_t face = patches_[first].face;
        end = std::min(firstOfFace_[face + 1], last);
        const Polygon& polygon = faces_.all[face].polygon;
        if (isBehind(patch.plane(), polygon, 0) || isBehind(patches_[first].plane(), patch.polygon, 0)) {
            counts.ofKind[0] += end - first;
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
            ++counts.ofKind[static_cast<std::size_t>(exchange.kind)];
            if (exchange.area > 0) exchange_.set(i, j, exchange.area);
            if (exchange.kind == VisibleExchange::Kind::partial)
                uncertain_[piece].push_back({static_cast<std::uint32_t>(j), static_cast<float>(exchange.error)});
        }
    }
    for (std::size_t kind = 0; kind < counts_.size(); ++kind)
        counts_[kind] += counts.ofKind[kind];
}

VisibleExchange ExchangeBuilder::knownExchange(std::size_t i, std::size_t j) const {
    using Kind = VisibleExchange::Kind;
    const std::uint32_t row = known_->from[i],
                        patch = known_->from[j]; // their order has not changed, so i is still the row
    const ExchangeBuilder& before = known_->builder;
    const std::vector<Uncertain>& uncertain = before.uncertain_[before.pieceOf(row, patch)];
    const double area = known_->exchange(row, patch);
    const auto found = std::ranges::lower_bound(uncertain, patch, {}, &Uncertain::patch);
    if (found != uncertain.end() && found->patch == patch) return {Kind::partial, area, double{found->error}};
    if (area > 0) return {Kind::full, area, 0};
    const bool faceAway =
        isBehind(patches_[i].plane(), patches_[j].polygon, 0) || isBehind(patches_[j].plane(), patches_[i].polygon, 0);
    return {faceAway ? Kind::none : Kind::hidden, 0, 0};
}

ExchangeCounts ExchangeBuilder::counts() const {
    ExchangeCounts counts;
    std::ranges::copy(counts_, counts.ofKind.begin());
    return counts;
}

std::vector<double> ExchangeBuilder::rowDeviations() const {
    std::vector<double> squares(patches_.size(), 0.0);
    for (std::size_t piece = 0; piece < uncertain_.size(); ++piece)
        for (const Uncertain& one : uncertain_[piece]) {
            const double square = static_cast<double>(one.error) * static_cast<double>(one.error);
            squares[piece / piecesPerRow_] += square;
            squares[one.patch] += square;
        }
    for (std::size_t i = 0; i < squares.size(); ++i)
        squares[i] = std::sqrt(squares[i]) / patches_[i].area;
    return squares;
}

} // namespace shadowlab::radiosity
