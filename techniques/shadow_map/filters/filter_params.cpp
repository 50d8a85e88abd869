// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/filters/filter_params.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::shadow_map {

int FilterParams::kernelRadius() const {
    switch (kind) {
    case Kind::hard: return 0;
    case Kind::hw2x2: return 1;
    case Kind::pcf: return pcfRadius;
    case Kind::disc: return static_cast<int>(std::ceil(discRadius));
    case Kind::pcss: return 1;
    default: return blurRadius + 1; // moments are interpolated between texels
    }
}

double FilterParams::comparedRadius() const {
    switch (kind) {
    case Kind::hw2x2: return 0.5;
    case Kind::pcf: return pcfRadius;
    case Kind::disc: return discRadius;
    case Kind::pcss: return 1; // its kernel has no fixed size; the receiver's plane is what serves it
    case Kind::evsm:
    case Kind::msm:
        // Of a plane that slants within the blur these take one end for something before the other: a lit floor would be
        // down to 0.7. What a single comparison is given is enough for 3 x 3 texels.
        return std::max(blurRadius - 1, 0);
    default: return 0; // a point on a plane is at its mean depth, and that is lit
    }
}

namespace {

using params::onlyIf;
using enum FilterParams::Kind;

/// The condition that this filter is chosen; it refers to `p`.
auto is(const FilterParams& p, FilterParams::Kind kind) {
    return [&p, kind] { return p.kind == kind; };
}

params::ParamList describeComparisons(FilterParams& p) {
    const auto takesSamples = [&p] { return p.kind == disc || p.kind == pcss; };
    return {
        params::choice("filter", p.kind, {"hard", "hw2x2", "pcf", "disc", "pcss", "vsm", "esm", "evsm", "msm"},
                       "hard: one comparison a pixel; hw2x2: four, weighted; pcf: a square of them; disc: some in a "
                       "disc; pcss: as many as the penumbra is wide; vsm, esm, evsm, msm: none, but averages of what "
                       "depths become."),
        onlyIf(is(p, pcf), params::integer("pcf-radius", p.pcfRadius, 0, 15, "texels",
                                           "PCF averages (2 r + 1) x (2 r + 1) comparisons.")),
        onlyIf(is(p, disc),
               params::real("disc-radius", p.discRadius, 0, 32, "texels", "filter disc: radius of the disc.")),
        onlyIf(takesSamples,
               params::integer("samples", p.samples, 1, 256, "", "disc and pcss: comparisons for one pixel.")),
        onlyIf(takesSamples,
               params::choice(
                   "noise", p.noise, {"texel", "pixel", "none"},
                   "disc and pcss turn their samples by chance: once for each texel, which stays on the surface; "
                   "for each pixel, which swims when the eye moves (teaching); not at all, which shows bands.")),
        onlyIf(is(p, pcss),
               params::real(
                   "light-radius", p.lightRadius, 0, 10, "m",
                   "pcss: half width of a light that has no area of its own; of a directional light, at a distance "
                   "of 1 m.")),
        onlyIf(is(p, pcss), params::integer("blocker-samples", p.blockerSamples, 1, 256, "",
                                            "pcss: depths that the search looks at.")),
        onlyIf(is(p, pcss), params::real("widest", p.widest, 0, 0.45, "",
                                         "pcss: no kernel is wider to one side than this share of the map.")),
    };
}

params::ParamList describeMoments(FilterParams& p) {
    const auto usesMoments = [&p] { return p.usesMoments(); };
    const auto hasVariance = [&p] { return p.kind == vsm || p.kind == evsm; };
    const auto hasBound = [&p] { return p.usesMoments() && p.kind != esm; };
    const auto hasExponents = [&p] { return p.kind == esm || p.kind == evsm; };
    return {
        onlyIf(usesMoments,
               params::integer("blur-radius", p.blurRadius, 0, 31, "texels",
                               "vsm to msm: the moments are averaged over (2 r + 1) x (2 r + 1) texels, once.")),
        onlyIf(
            usesMoments,
            params::boolean("mipmaps", p.mipmaps,
                            "vsm to msm: coarser moments where texels are smaller than pixels (not for logarithms).")),
        onlyIf(usesMoments,
               params::choice("moment-format", p.momentFormat, {"32f", "16f"},
                              "vsm to msm: bits of a moment; 16f shows what rounding does to them (teaching).")),
        onlyIf(hasVariance,
               params::real(
                   "least-deviation", p.leastDeviation, 0, 0.1, "",
                   "vsm and evsm: depths are taken to vary by at least this share of the map's range; 0 shows what "
                   "rounding does (teaching).")),
        onlyIf(hasBound,
               params::real(
                   "bleed-reduction", p.bleedReduction, 0, 0.99, "",
                   "vsm, evsm and msm: what is no more lit than this is dark; 0 shows the light that bleeds through "
                   "two surfaces (teaching).")),
        onlyIf(is(p, esm), params::real("esm-exponent", p.esmExponent, 0, 400, "",
                                        "esm: c in exp(c z), z from 0 to 1 in the map's range.")),
        onlyIf(
            is(p, esm),
            params::boolean("esm-logarithms", p.esmLogarithms,
                            "esm: keep c z instead of exp(c z), which overflows; false: exp(c z) itself (teaching).")),
        onlyIf(is(p, evsm),
               params::choice(
                   "evsm-moments", p.evsmMoments, {"2", "4"},
                   "evsm: of the positive exponential alone, or of the negative one as well, which leaks where the "
                   "other does not.")),
        onlyIf(is(p, evsm),
               params::real("evsm-exponent", p.evsmExponent, 0, 100, "", "evsm: c in exp(c z), z from -1 to 1.")),
        onlyIf(is(p, evsm), params::real("evsm-negative", p.evsmNegative, 0, 100, "", "evsm: c in -exp(-c z).")),
        onlyIf(hasExponents,
               params::boolean(
                   "exponent-limit", p.exponentLimit,
                   "esm and evsm: no exponent larger than the format can hold; false: infinities (teaching).")),
        onlyIf(is(p, msm),
               params::real("msm-bias", p.msmBias, 0, 0.1, "",
                            "msm: share of moments that no depths can have, against rounding in a kernel of "
                            "radius 1 (wider ones take more of it); more lets light through.")),
    };
}

} // namespace

params::ParamList describe(FilterParams& p) {
    params::ParamList all = describeComparisons(p);
    for (params::Param& param : describeMoments(p))
        all.push_back(std::move(param));
    return all;
}

} // namespace shadowlab::shadow_map
