// A final gather that pixels share: some gather (gather_rays.h), and those beside them take over what they found, where it cannot
// be much different.
//
// Light that was reflected changes slowly, but for places near other surfaces. So G. Ward, F. Rubinstein and R. Clear ("A Ray Tracing
// Solution for Diffuse Interreflection", SIGGRAPH 1988) estimate the error of taking an irradiance from one point to another: the
// distance between them, relative to how far away is what the one sees (the harmonic mean R), and how much the normals differ. Where
// no pixel around has anything good enough, as in corners and on leaves, a pixel gathers by itself.
// So pixels of a lattice gather, and others take over; of those that may not, such as are on a lattice half as wide, and so on down to
// single pixels. Of each narrower lattice every other place gathers first, like the black squares of a chessboard, since places between
// them can often take over. What is close to a pixel and unknown to the records around it, its neighbours in the picture show.
// Simplified: points stand in a lattice of pixels, not where the error asks for them; gradients come from a plane through several.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "techniques/radiosity/display/gather_rays.h"

namespace shadowlab::radiosity {

class SharedGather {
public:
    /// Goes on until every pixel has its irradiance (true) or the deadline has passed, but always does some work. Begins anew when the
    /// solution, the scene or the eye is another one. `light` must be complete. `rays`: of each pixel of the wide lattices; those of
    /// the narrow ones, on leaves and in corners, make do with a half or a quarter.
    bool advance(const GatherSolution& solution, const PixelLight& light, std::size_t rays, Deadline deadline);

    /// Changes when another irradiance is there.
    [[nodiscard]] std::uint64_t version() const { return version_; }
    /// The irradiance by all but direct light, W/m^2; row 0 is at the bottom. Of pixels without a surface 0. Once advance() has
    /// returned true.
    [[nodiscard]] const std::vector<vec4>& irradianceFromBelow() const { return irradianceFromBelow_; }
    /// How many pixels have gathered.
    [[nodiscard]] std::size_t gathered() const { return records_.size(); }

private:
    /// What one pixel has found.
    struct Record {
        dvec3 positionCentred{0.0}, normal{0.0}, irradiance{0.0};
        double range = 0;       ///< R, metres
        bool hasChosen = false; ///< rays to chosen points bring a part of it
    };
    void restart(const PixelLight& light);
    void chooseGathering();
    [[nodiscard]] Record recordAt(const GatherSolution& solution, const PixelLight& light, ivec2 pixel) const;
    bool share(const PixelLight& light, Deadline deadline);
    [[nodiscard]] double mostRange(const PixelLight& light, ivec2 pixel, const dvec3& positionCentred, const dvec3& normal) const;
    [[nodiscard]] bool takeOver(const PixelLight& light, ivec2 pixel, dvec3& irradiance) const;
    [[nodiscard]] std::size_t indexOf(ivec2 pixel) const;
    [[nodiscard]] int widestSpacing() const;
    [[nodiscard]] double shareOfRays() const;

    GatherKey key_;
    int spacing_ = 0;                     ///< of the lattice, pixels
    bool isWhole_ = true;                 ///< all its places gather; false: every other one
    std::vector<ivec2> open_;             ///< pixels that have no irradiance yet
    std::vector<ivec2> gathering_;        ///< those of them that are on the lattice: the last of `records_` are theirs
    std::size_t nextPiece_ = 0;           ///< of those
    std::vector<std::uint8_t> isDone_;    ///< of open pixels: has taken over what others have found
    std::size_t nextShared_ = 0;          ///< piece of open pixels
    std::vector<Record> records_;
    std::vector<std::int32_t> recordOf_;  ///< of each pixel, rows from the top: its record, or kNone
    std::uint64_t version_ = 0;
    std::vector<vec4> irradianceFromBelow_;
};

} // namespace shadowlab::radiosity
