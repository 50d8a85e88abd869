// A final gather of every pixel (gather_rays.h), one ray more for each at a time: noise that gets less while one looks on.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/radiosity/display/gather_rays.h"

namespace shadowlab::radiosity {

class PixelGather {
public:
    /// Goes on until all pixels have sent `rays` (true) or the deadline has passed, but always does some work. Begins anew when the
    /// solution, the scene or the eye is another one. `light` must be complete.
    bool advance(const GatherSolution& solution, const PixelLight& light, std::size_t rays, Deadline deadline);

    /// Changes with every ray.
    [[nodiscard]] std::uint64_t version() const { return version_; }
    /// Can it be shown? Not before each pixel has sent a ray.
    [[nodiscard]] bool hasPicture() const { return done_ > 0; }
    /// The irradiance by all but direct light, W/m^2, the mean of the rays so far; row 0 is at the bottom. Of pixels without a surface 0.
    [[nodiscard]] std::vector<vec4> irradianceFromBelow() const;

private:
    void gatherBlock(const GatherSolution& solution, const PixelLight& light, std::size_t block);

    GatherKey key_;
    std::vector<dvec3> sums_; ///< of each pixel, rows from the top
    std::size_t done_ = 0, nextBlock_ = 0;
    std::uint64_t version_ = 0;
};

} // namespace shadowlab::radiosity
