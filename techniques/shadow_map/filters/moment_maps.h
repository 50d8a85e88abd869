// Maps of moments, which can be averaged: functions of the depths around each texel, for the filters vsm to msm
// (shaders/shadow_map/moments/moments_of_*.glsl).
// SPDX-License-Identifier: MIT
#pragma once
#include <map>

#include "techniques/foundation/gl/framebuffer.h"
#include "techniques/foundation/gl/program.h"
#include "techniques/shadow_map/fit/light_maps.h"
#include "techniques/shadow_map/params.h"

namespace shadowlab::shadow_map {

/// The exponents that are used: those that were asked for, or, with exponentLimit, the largest that the format can hold.
struct Exponents {
    double esm = 0;
    dvec2 evsm{0.0}; ///< of the positive exponential, and of the negative one
};
Exponents exponents(const FilterParams& params);

/// The share of valid moments that is mixed in against rounding: msmBias for kernels of radius 1, more for wider ones, whose sums round
/// more often.
double msmBias(const FilterParams& params);

/// Are logarithms averaged, and not what they stand for?
bool averagesLogarithms(const FilterParams& params);

/// Of the parameters those that moments depend on; all others as by default.
FilterParams momentParams(const FilterParams& params);

/// The texture that the moments of a map go into.
gl::ColorTextureArray emptyMoments(const FilterParams& params, int resolution, int layers);

/// Metres along the cameras' axes that moments count as -1 and 1.
vec2 momentDepthRange(const LightMaps& maps);

class MomentMaker {
public:
    /// Fills `moments` from the depths of all layers. The depths are left to be read as they are.
    void make(const gl::DepthTextureArray& depth, const LightMaps& maps, const FilterParams& params,
              const gl::ColorTextureArray& moments);

private:
    struct Programs {
        gl::Program rows, columns;
    };
    const Programs& programsFor(const FilterParams& params);

    std::map<std::pair<FilterKind, bool>, Programs> programs_; ///< of a filter, and whether it averages logarithms
    gl::Texture2D averagedRows_; ///< kept: for a software renderer, allocating it costs as much as filling it
};

} // namespace shadowlab::shadow_map
