// The random numbers of distributed ray tracing: where a ray passes through its pixel and the lens, at what time, toward which
// point on a light, in which direction of a lobe.
//
// A sample needs a pair of numbers for each of these decisions (a *dimension*). All samples of a pixel together should fill the
// unit square of each dimension evenly, but dimensions must be independent: otherwise the left side of the pixel would always see
// the left side of the lamp. R. L. Cook, "Stochastic Sampling in Computer Graphics", ACM Transactions on Graphics 1986. A number
// depends only on the pixel, the sample and the dimension, so it does not matter in which order, or on how many threads, they are
// computed.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "techniques/foundation/math/types.h"

namespace shadowlab::ray_tracing {

struct SamplePattern {
    int count = 1; ///< samples of a pixel
    enum class Spread {
        jittered,      ///< one at random in each of `count` equal cells
        regular,       ///< in the middle of each cell, the same in every pixel
        random,        ///< anywhere
        lowDiscrepancy ///< scrambled Sobol' points: every part of the sequence is evenly distributed
    } spread = Spread::jittered;
    double jitter = 1.0; ///< jittered: the largest offset from the centre of a cell, relative to half the cell
    int seed = 0;
    friend bool operator==(const SamplePattern&, const SamplePattern&) = default;
};

/// The decision that a pair of numbers is for. Every node of a tree has numbers of its own, so that its rays are sampled
/// independently.
enum class Purpose : std::uint32_t { pixel, lens, time, reflection, refraction, diffuse, light, survival };

class SampleNumbers {
public:
    /// The numbers of one sample (0 ... count - 1) of one pixel.
    SampleNumbers(const SamplePattern& pattern, ivec2 pixel, std::uint32_t sample);

    /// Two numbers in [0, 1). `place` distinguishes nodes and lights. Numbers with `attempt` above 0 are plainly random.
    [[nodiscard]] dvec2 pair(Purpose purpose, std::uint64_t place = 0, std::uint32_t attempt = 0) const;
    /// Lower and upper corner of the cell of such a pair, for patterns that divide the unit square into one cell per sample.
    [[nodiscard]] std::optional<std::array<dvec2, 2>> cell(Purpose purpose, std::uint64_t place = 0) const;
    /// One number in [0, 1).
    [[nodiscard]] double one(Purpose purpose) const;

private:
    [[nodiscard]] std::uint64_t dimensionOf(Purpose purpose, std::uint64_t place) const;
    [[nodiscard]] int cellIn(std::uint64_t dimension) const;

    SamplePattern pattern_;
    std::uint64_t pixelKey_;
    std::uint32_t sample_;
};

} // namespace shadowlab::ray_tracing
