// Lamps in the way of light that surfaces send each other.
//
// Lamps are no patches, so that they may move without a new room, and form factors know nothing of them. But a lamp is a body that takes in what meets it. In a room
// of bright walls light passes a lamp ten times, and one that takes in a hundredth each time makes the room a tenth darker. So the exchange of two patches is that part of it
// that passes all lamps by, found with lines between sample points of both, as what other bodies leave of it is (form_factors/visible_exchange.h).
// Simplified: what lamps hide of the surroundings stays.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

#include "techniques/radiosity/exchange/exchange_matrix.h"
#include "techniques/radiosity/room/room.h"

namespace shadowlab::radiosity {

/// Of its mesh, m^2.
double surfaceArea(const scene::Object& object);

/// A lamp as what is drawn of it: a rect, or a ball as large as its mesh.
class LampBody {
public:
    /// `lamp` has an area; `surface`: the object that is drawn for it.
    LampBody(const scene::Light& lamp, const scene::Object& surface, const dvec3& originWorld);
    /// Does the line meet it?
    [[nodiscard]] bool blocks(const dvec3& fromCentred, const dvec3& toCentred) const;
    /// Does the place lie within it? A surface that cuts a ball sends nothing there (lamp_cover.h).
    [[nodiscard]] bool holds(const dvec3& placeCentred) const { return radius_ > 0 && glm::distance(placeCentred, middle_) < radius_; }
    /// May it meet a line between points that lie at most `around` metres from those two?
    [[nodiscard]] bool mayBlock(const dvec3& fromCentred, const dvec3& toCentred, double around) const;

private:
    dvec3 middle_{0.0}, normal_{0.0};
    double radius_ = 0;                    ///< of a ball
    dvec3 alongU_{0.0}, alongV_{0.0};      ///< of a rect: their product with an offset is -1..1 within it
    double reach_ = 0;                     ///< no point of it is farther from its middle, metres
};

/// A pair of patches, i < j, and a share or an exchange area of it.
struct PairValue {
    std::uint32_t i = 0, j = 0;
    double value = 0;
};

class LampsBetweenBuilder {
public:
    /// The room must outlive this object.
    LampsBetweenBuilder(const Room& room, std::vector<LampBody> lamps);

    /// Continues until all is done (true) or the deadline has passed, but always does some work. The numbers do not depend on deadlines or on the number
    /// of threads.
    bool advance(std::chrono::steady_clock::time_point deadline);
    /// Of each pair with lamps in between, the share of its exchange that passes them by, 0..1.
    [[nodiscard]] std::vector<PairValue> take();

private:
    void fill(std::size_t row);
    [[nodiscard]] double sharePast(const Patch& a, const Patch& b, std::optional<Blockers>& ofFace) const;

    const Room& room_;
    std::vector<LampBody> lamps_;
    std::vector<double> sizes_; ///< of each patch, metres: how far its points are from its centre at most
    std::vector<std::vector<PairValue>> rows_;
    std::size_t next_ = 0;
};

/// Leaves these shares of the exchange of these pairs. Returns what there was before.
std::vector<PairValue> leaveShares(ExchangeMatrix& matrix, std::span<const PairValue> shares);
/// Puts back what there was before.
void putBack(ExchangeMatrix& matrix, std::span<const PairValue> before);

} // namespace shadowlab::radiosity
