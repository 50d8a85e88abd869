// The parameters of the shadow map's filters.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/gl/texture.h"
#include "techniques/foundation/params/param.h"

namespace shadowlab::shadow_map {

/// A filter, by its place in the table of filters (filters.h).
enum class FilterKind : int {};
/// Throws Error (bug) where there is none of that name.
FilterKind filterNamed(std::string_view name);

/// How the answers of several texels become one. All filters' parameters are here; which of them one reads, its entry says.
struct FilterParams {
    FilterKind kind = filterNamed("pcf");
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

    /// Does it read averaged moments of the depths, instead of comparing depths?
    [[nodiscard]] bool usesMoments() const;
    /// Does it need the depths of the casters themselves? A plain comparison only needs to know that one is nearer.
    [[nodiscard]] bool usesDistances() const;
    /// Texels on each side of the point's own that may be read as well; pcss: beside those of the penumbra.
    [[nodiscard]] int kernelRadius() const;
    /// The radius that a bias has to cover, in texels: how far from its own texel a point is compared.
    [[nodiscard]] double comparedRadius() const;
};

/// The descriptions refer to the fields of `params`. Each has an effect only with the filters whose entries name it.
params::ParamList describe(FilterParams& params);

} // namespace shadowlab::shadow_map
