// The delta form factors of a hemicube's pixels: exact ones sum to 1, those of midpoints do not.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/form_factors/hemicube_pixels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include <glm/gtc/constants.hpp>

namespace shadowlab::radiosity {
namespace {

/// By the formula of the pixels' midpoints: the cosine at the origin times the cosine at the pixel, over pi times the distance
/// squared, times the area.
double midpointSum(int side) {
    const double step = 2.0 / side;
    double sum = 0;
    for (const HemicubeFace& face : kHemicubeFaces)
        for (int row = 0; row < face.rows * side / 2; ++row)
            for (int column = 0; column < side; ++column) {
                const dvec3 middle = face.forward + ((column + 0.5) * step - 1) * face.right() +
                                     (1 - face.rows + (row + 0.5) * step) * face.up;
                const double square = glm::dot(middle, middle);
                sum += middle.z / (glm::pi<double>() * square * square) * step * step;
            }
    return sum;
}

TEST(HemicubePixels, DeltaFormFactorsSumToOne) {
    for (const int side : {8, 16, 32, 64, 128, 256, 512}) {
        const std::vector<double> deltas = deltaFormFactors(side);
        ASSERT_EQ(deltas.size(), 3u * static_cast<unsigned>(side) * static_cast<unsigned>(side));
        // Some hundred thousand numbers, each right to 1e-15 of the angle it is seen under.
        EXPECT_NEAR(std::accumulate(deltas.begin(), deltas.end(), 0.0), 1, 1e-11) << side;
        for (const double delta : deltas)
            ASSERT_GT(delta, 0);
    }
    // Their error is the square of a pixel, and a sum is promised to be right to a millionth.
    for (const int side : {8, 16, 32, 64, 128, 256})
        EXPECT_GT(std::abs(midpointSum(side) - 1), 1e-6) << side;
}

/// Above a square twice as wide as it is far away: four times that of a square below its corner, .138531605995 (J. R. Howell's
/// catalogue of configuration factors, entry B-3). What is left goes to four equal sides.
TEST(HemicubePixels, EachFaceHasItsShare) {
    constexpr int kSide = 16;
    const std::vector<double> deltas = deltaFormFactors(kSide);
    std::size_t next = 0;
    for (std::size_t face = 0; face < kHemicubeFaces.size(); ++face) {
        ASSERT_EQ(next, static_cast<std::size_t>(kHemicubeFaces[face].firstRow * kSide / 2 * kSide));
        double sum = 0;
        for (int pixel = 0; pixel < kHemicubeFaces[face].rows * kSide / 2 * kSide; ++pixel)
            sum += deltas[next++];
        const double upper = 4 * .138531605995;
        EXPECT_NEAR(sum, face == 0 ? upper : (1 - upper) / 4, 1e-11) << face; // a dozen printed digits
    }
}

} // namespace
} // namespace shadowlab::radiosity
