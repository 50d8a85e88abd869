// The numbers that decide by chance: where in its pixel a ray passes, where through the lens, at what time, toward which place
// on a light, into which direction of a lobe.
//
// One sample asks for a pair of numbers for each of these (a *dimension*). All samples of a pixel together should fill the unit
// square of each dimension evenly, but no dimension should know of another: else the left side of the pixel would
// always see the left side of the lamp. R. L. Cook, "Stochastic Sampling in Computer Graphics", ACM Transactions on
// Graphics 1986. The numbers depend on the pixel, the sample and the dimension, and on nothing else: whoever asks, in
// whatever order, on however many threads, hears the same.
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
        jittered,      ///< one in each of `count` equal cells, by chance within it
        regular,       ///< in the middle of each cell, in every pixel alike
        random,        ///< anywhere
        lowDiscrepancy ///< scrambled Sobol' points: evenly spread whatever part of them is used
    } spread = Spread::jittered;
    double jitter = 1.0; ///< jittered: how far from the middle of its cell, as a share of what the cell allows
    int seed = 0;
    friend bool operator==(const SamplePattern&, const SamplePattern&) = default;
};

/// What a pair of numbers is for. A node of a tree of rays has its own, so that its rays are spread on their own.
enum class Purpose : std::uint32_t { pixel, lens, time, reflection, refraction, diffuse, light };

class SampleNumbers {
public:
    /// Those of one sample (0 ... count - 1) of one pixel.
    SampleNumbers(const SamplePattern& pattern, ivec2 pixel, std::uint32_t sample);

    /// Two numbers in [0, 1). `place` tells nodes and lights apart. `attempt`: later ones are free of any pattern.
    [[nodiscard]] dvec2 pair(Purpose purpose, std::uint64_t place = 0, std::uint32_t attempt = 0) const;
    /// Lower and upper corner of the cell that such a pair lies in, where the unit square is cut into one for each sample.
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
