// The room that benches of radiosity solve.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <optional>
#include <vector>

#include "techniques/radiosity/equations/problem.h"
#include "techniques/radiosity/exchange/exchange_builder.h"

namespace shadowlab::radiosity {

/// The built-in scene cornell-room. Its lamp is a surface like others, which emits pi times the lamp's radiance, as diffuse ones do, and
/// isBlocked the ceiling behind it.
struct CornellRoom {
    /// Cut into so many patches at most, each then so many times into four, and all where other things touch them.
    explicit CornellRoom(std::size_t mostPatches, int halvings = 0);
    CornellRoom(const CornellRoom&) = delete; // the occlusion points into it
    CornellRoom& operator=(const CornellRoom&) = delete;

    [[nodiscard]] std::vector<double> areas() const;
    [[nodiscard]] Problem problem(const ExchangeMatrix& exchange) const {
        return {exchange, areas(), emission, reflectance};
    }
    [[nodiscard]] bool isLamp(std::size_t patch) const { return emission[patch] != dvec3(0); }

    Faces faces;
    std::vector<Patch> patches;
    std::optional<Occlusion> occlusion;
    std::vector<dvec3> emission, reflectance; ///< W/m^2; of each patch

private:
    std::optional<trace::Bvh> bvh_;
};

/// As many lines for a patch that sees everything in part as the technique tries. Patches of a room cut into a thousand get the
/// least number there is, 8 for a pair.
constexpr double kLinesPerPatch = 1e4;

inline ExchangeMatrix exactExchange(const CornellRoom& room) {
    ExchangeBuilder builder(room.faces, room.patches, *room.occlusion, kLinesPerPatch);
    builder.advance(std::chrono::steady_clock::time_point::max());
    return builder.take();
}

/// To a millionth of the largest radiosity, by conjugate gradients.
std::vector<dvec3> solved(const Problem& problem);

} // namespace shadowlab::radiosity
