// Computes the exchange areas of all pairs of patches, row by row and of each row some patches at a time, in slices of time.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <atomic>
#include <chrono>
#include <optional>
#include <span>

#include "techniques/radiosity/exchange/exchange_matrix.h"
#include "techniques/radiosity/form_factors/visible_exchange.h"

namespace shadowlab::radiosity {

/// The number of pairs of each VisibleExchange::Kind.
struct ExchangeCounts {
    std::array<std::size_t, 4> ofKind{};
    [[nodiscard]] std::size_t of(VisibleExchange::Kind kind) const { return ofKind[static_cast<std::size_t>(kind)]; }
};

class ExchangeBuilder;

/// What an earlier builder has found between patches of the same faces, some of which have been cut since. Between two patches
/// that have not been cut nothing has changed.
struct KnownExchange {
    const ExchangeBuilder& builder; ///< complete, with the same number of lines
    const ExchangeMatrix& exchange; ///< as that builder found it
    /// For each new patch its number there, or kNew; unchanged patches keep their order.
    std::span<const std::uint32_t> from;

    static constexpr std::uint32_t kNew = ~std::uint32_t{0};
};

class ExchangeBuilder {
public:
    /// All arguments must outlive this object. Patches lie in the order of their faces, as cutIntoPatches() returns them. With
    /// `known`, which must live until all is done, only pairs with a new patch are computed; the numbers are the same as without
    /// it (of pairs that exchange nothing, some that face away by a rounding error are counted as hidden).
    ExchangeBuilder(const Faces& faces, const std::vector<Patch>& patches, const Occlusion& occlusion,
                    double linesPerPatch, std::optional<KnownExchange> known = std::nullopt);

    /// Continues until all is done (true) or the deadline has passed, but always does some work. The numbers do not depend on
    /// deadlines or on the number of threads.
    bool advance(std::chrono::steady_clock::time_point deadline);
    /// 0..1 of all pairs.
    [[nodiscard]] double done() const;

    [[nodiscard]] const ExchangeMatrix& exchange() const { return exchange_; }
    [[nodiscard]] ExchangeMatrix take() { return std::move(exchange_); }
    [[nodiscard]] ExchangeCounts counts() const;
    /// For each patch, an upper bound of the standard deviation of its row sum, due to the sampling of partly visible pairs.
    [[nodiscard]] std::vector<double> rowDeviations() const;

private:
    /// The error of one number of a piece.
    struct Uncertain {
        std::uint32_t patch;
        float error; ///< m^2
    };
    void fill(std::size_t piece);
    [[nodiscard]] std::size_t pieceOf(std::size_t row, std::size_t patch) const;
    [[nodiscard]] VisibleExchange knownExchange(std::size_t i, std::size_t j) const;

    const Faces& faces_;
    const std::vector<Patch>& patches_;
    const Occlusion& occlusion_;
    double linesPerPatch_;
    std::optional<KnownExchange> known_;
    std::vector<std::size_t> firstOfFace_; ///< patch; one more than faces
    ExchangeMatrix exchange_;
    std::size_t piecesPerRow_;
    /// Of each piece of a row, in the order of patches. Apart, so that sums of them do not depend on the order of threads.
    std::vector<std::vector<Uncertain>> uncertain_;
    std::array<std::atomic<std::size_t>, 4> counts_{}; ///< of each VisibleExchange::Kind
    std::size_t next_ = 0;                             ///< piece
};

} // namespace shadowlab::radiosity
