// The knobs of the shadow map's filters.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/gl/texture.h"
#include "techniques/foundation/params/param.h"

namespace shadowlab::shadow_map {

/// How the answers of several texels become one (shaders/shadow_map/filter_*.glsl).
struct FilterParams {
    enum class Kind { hard, hw2x2, pcf, disc, pcss, vsm, esm, evsm, msm } kind = Kind::pcf;
    int pcfRadius = 1;
    double discRadius = 2.0;
    int samples = 16;
    enum class Noise { texel, pixel, none } noise = Noise::texel;
    double lightRadius = 0.0;
    int blockerSamples = 16;
    double widest = 0.4;
    int blurRadius = 1;
    bool mipmaps = false;
    enum class MomentFormat { float32, float16 } momentFormat = MomentFormat::float32;
    double leastDeviation = 1e-4;
    double bleedReduction = 0.1;
    double esmExponent = 200.0;
    bool esmLogarithms = true;
    enum class EvsmMoments { two, four } evsmMoments = EvsmMoments::four;
    double evsmExponent = 40.0, evsmNegative = 40.0;
    bool exponentLimit = true;
    double msmBias = 1e-6;
    friend bool operator==(const FilterParams&, const FilterParams&) = default;

    /// Does it average what the map's depths become, and not comparisons with them?
    [[nodiscard]] bool usesMoments() const { return kind >= Kind::vsm; }
    /// Does it need the depths of what stands before the receivers, and not only that something does?
    [[nodiscard]] bool usesDistances() const { return usesMoments() || kind == Kind::pcss; }
    /// Texels around the point's own that may be asked as well; pcss: beside those of the penumbra.
    [[nodiscard]] int kernelRadius() const;
    /// The same for what a bias has to cover: how far beside its own texel a point is compared.
    [[nodiscard]] double comparedRadius() const;
};

/// The descriptions refer to the fields of `params`.
params::ParamList describe(FilterParams& params);

} // namespace shadowlab::shadow_map
