// Flicker: pixels that change between lit and dark from one frame to the next although the truth does not.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

namespace shadowlab::judge {

class ExcessFlips {
public:
    /// The next frame: one byte a pixel, 1 where it is lit, and the length of the true boundary in pixels.
    void addFrame(std::vector<std::uint8_t> lit, std::vector<std::uint8_t> truthLit, double boundaryPx);

    /// Flips without reason over all frames, per pixel of true boundary (of the frames after the first). Nothing for a
    /// single frame, or when there is no boundary. 0 for whoever is exact, however fast things move.
    [[nodiscard]] std::optional<double> rate() const;

private:
    std::vector<std::uint8_t> lit_, truthLit_;
    std::uint64_t flips_ = 0;
    double boundaryPx_ = 0;
};

} // namespace shadowlab::judge
