// Lines through lamps: along them, patches do not see each other.
//
// Lamps are no patches, so that they may move without a new room, and form factors know nothing of them. But a lamp is a body that takes in what meets it. In a room
// of bright walls light passes a lamp ten times, and one that takes in a thousandth each time makes the room a hundredth darker. So what passes
// through lamps is taken out of the exchange areas. It is found by lines through them: all lines that leave the surface of a convex body, in all directions and evenly (by the
// cosine), are all lines through it (M. Crofton, "On the Theory of Local Probability", 1868). Each joins two patches, and stands for as much exchange area as all others.
// Simplified: what lamps hide of the surroundings stays.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/radiosity/display/surface_cells.h"
#include "techniques/radiosity/exchange/exchange_matrix.h"
#include "techniques/radiosity/room/room.h"

namespace shadowlab::radiosity {

/// A pair of patches, i < j, and an exchange area, m^2.
struct ExchangeArea {
    std::uint32_t i = 0, j = 0;
    double area = 0;
};

class LampLinesBuilder {
public:
    /// Room and cells must outlive this object. `drawn`: the scene as it is drawn, to which the cells belong. `isInTheWay`: for each of its lights, 1 or 0.
    LampLinesBuilder(const Room& room, const SurfaceCells& cells, scene::Snapshot drawn, std::vector<std::uint8_t> isInTheWay);

    /// Continues until all is done (true) or the deadline has passed, but always does some work. The numbers do not depend on deadlines or on the number
    /// of threads.
    bool advance(std::chrono::steady_clock::time_point deadline);
    /// What passes through lamps, for each pair of patches of which something does, in their order.
    [[nodiscard]] std::vector<ExchangeArea> take();

private:
    /// A side of a triangle, from which lines leave the lamp.
    struct Side {
        trace::SurfacePoint middle;
        bool isClosed = false; ///< of a body with an inside
        double upTo = 0;       ///< its area and that of those before it, m^2
    };
    using Pair = std::pair<std::uint32_t, std::uint32_t>; ///< of patches that a line joins, the lower number first
    void findSides();
    void send(std::size_t piece);

    const Room& room_;
    const SurfaceCells& cells_;
    scene::Snapshot drawn_;
    std::vector<std::uint8_t> isInTheWay_;
    trace::SceneTracer tracer_;
    bool isPrepared_ = false;
    std::vector<Side> sides_;
    std::vector<std::vector<Pair>> pieces_;
    std::size_t nextPiece_ = 0;
};

/// Takes them out of the matrix. What by chance is more than a pair exchanges, is taken from the next. Returns what was there before.
std::vector<ExchangeArea> takeOut(ExchangeMatrix& matrix, std::span<const ExchangeArea> taken);
/// Puts back what was there before.
void putBack(ExchangeMatrix& matrix, std::span<const ExchangeArea> before);

} // namespace shadowlab::radiosity
