// A final gather that pixels share: some gather (gather_rays.h), and those beside them take over what they found, where it cannot
// be much different.
//
// Light that was reflected changes slowly, but for places near other surfaces. So G. Ward, F. Rubinstein and R. Clear ("A Ray Tracing
// Solution for Diffuse Interreflection", SIGGRAPH 1988) estimate the error of taking an irradiance from one point to another: the
// distance between them, relative to how far away is what the one sees (the harmonic mean R), and how much the normals differ. Where
// no pixel around has anything good enough, as in corners and on leaves, a pixel gathers by itself.
// Simplified: points stand in a lattice of pixels, not where the error asks for them; gradients come from a plane through several.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/radiosity/display/gather_rays.h"

namespace shadowlab::radiosity {

class SharedGather {
public:
    /// Goes on until every pixel has its irradiance (true) or the deadline has passed, but always does some work. Begins anew when the
    /// solution, the scene or the eye is another one. `light` must be complete. `rays`: of each pixel of the lattice; one that
    /// gathers by itself, on leaves and in corners, makes do with half.
    bool advance(const GatherSolution& solution, const PixelLight& light, std::size_t rays, Deadline deadline);

    /// Changes when another irradiance is there.
    [[nodiscard]] std::uint64_t version() const { return version_; }
    /// The irradiance by all but direct light, W/m^2; row 0 is at the bottom. Of pixels without a surface 0. Once advance() has
    /// returned true.
    [[nodiscard]] const std::vector<vec4>& irradianceFromBelow() const { return irradianceFromBelow_; }
    /// How many pixels gathered by themselves, besides those of the lattice.
    [[nodiscard]] std::size_t alone() const { return alone_.size(); }

private:
    /// What one pixel of the lattice has found.
    struct Record {
        bool isThere = false; ///< it shows a surface
        dvec3 positionCentred{0.0}, normal{0.0}, irradiance{0.0};
        double range = 0; ///< R, metres
    };
    [[nodiscard]] ivec2 cells() const;
    [[nodiscard]] ivec2 latticePixel(ivec2 cell) const;
    [[nodiscard]] Record recordAt(const GatherSolution& solution, const PixelLight& light, ivec2 pixel, std::size_t count) const;
    void share(const PixelLight& light);
    [[nodiscard]] bool takeOver(const PixelLight& light, ivec2 pixel, dvec3& irradiance) const;
    [[nodiscard]] vec4& pixelFromBelow(ivec2 pixel);

    GatherKey key_;
    std::vector<Record> records_;
    std::size_t nextRecord_ = 0, nextAlone_ = 0;
    bool isShared_ = false;
    std::uint64_t version_ = 0;
    std::vector<ivec2> alone_; ///< pixels that gather by themselves
    std::vector<vec4> irradianceFromBelow_;
};

} // namespace shadowlab::radiosity
