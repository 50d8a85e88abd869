// All exchange areas of a scene's patches, row by row, as long as there is time.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <chrono>
#include <optional>
#include <span>

#include "techniques/radiosity/exchange/exchange_matrix.h"
#include "techniques/radiosity/form_factors/visible_exchange.h"

namespace shadowlab::radiosity {

/// Of how many pairs of patches what was found, by VisibleExchange::Kind, and how far from the truth their sum may be.
struct ExchangeCounts {
    std::array<std::size_t, 4> ofKind{};
    [[nodiscard]] std::size_t of(VisibleExchange::Kind kind) const { return ofKind[static_cast<std::size_t>(kind)]; }
};

class ExchangeBuilder;

/// What an earlier builder has found between patches of the same faces, of which some are cut by now. Between two that are as they
/// were nothing has changed.
struct KnownExchange {
    const ExchangeBuilder& builder;      ///< all done, with as many lines
    const ExchangeMatrix& exchange;      ///< as it was found, wherever it is by now
    std::span<const std::uint32_t> from; ///< of each new patch its number there, or kNew; in their order, as they were

    static constexpr std::uint32_t kNew = ~std::uint32_t{0};
};

class ExchangeBuilder {
public:
    /// All must live as long. Patches lie in the order of their faces, as cutIntoPatches() leaves them. With `known`, which must
    /// live until all is done, only pairs with a new patch take time; the numbers are those that it would find without
    /// (of pairs that exchange nothing, some that face away by a rounding are counted as hidden).
    ExchangeBuilder(const Faces& faces, const std::vector<Patch>& patches, const Occlusion& occlusion,
                    double linesPerPatch, std::optional<KnownExchange> known = std::nullopt);

    /// Goes on until all is done (true) or the time has come, but always a bit. The numbers are the same for any deadlines and
    /// any number of threads.
    bool advance(std::chrono::steady_clock::time_point deadline);
    /// 0..1 of all pairs.
    [[nodiscard]] double done() const;

    [[nodiscard]] const ExchangeMatrix& exchange() const { return exchange_; }
    [[nodiscard]] ExchangeMatrix take() { return std::move(exchange_); }
    [[nodiscard]] ExchangeCounts counts() const;
    /// Of each patch, one standard deviation at most of its row sum, from lines that were tried where patches are seen in part.
    [[nodiscard]] std::vector<double> rowDeviations() const;

private:
    /// The error of one number of a row.
    struct Uncertain {
        std::uint32_t patch;
        float error; ///< m^2
    };
    /// What is found out in a row, kept apart, so that sums do not depend on who was first.
    struct Row {
        ExchangeCounts counts;
        std::vector<Uncertain> uncertain; ///< by the numbers of the patches
    };
    void fill(std::size_t i);
    [[nodiscard]] VisibleExchange knownExchange(std::size_t i, std::size_t j) const;

    const Faces& faces_;
    const std::vector<Patch>& patches_;
    const Occlusion& occlusion_;
    double linesPerPatch_;
    std::optional<KnownExchange> known_;
    std::vector<std::size_t> firstOfFace_; ///< patch; one more than faces
    ExchangeMatrix exchange_;
    std::vector<Row> rows_;
    std::size_t next_ = 0; ///< row
};

} // namespace shadowlab::radiosity
