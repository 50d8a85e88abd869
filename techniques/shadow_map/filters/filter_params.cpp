// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/filters/filter_params.h"

#include "techniques/shadow_map/filters/filters.h"

namespace shadowlab::shadow_map {

namespace {

std::vector<params::Named> filterChoices() {
    std::vector<params::Named> choices;
    for (const FilterInfo& filter : filters())
        choices.emplace_back(filter.name, filter.what);
    return choices;
}

// In no group, and so basic, is how wide a filter's kernel is: a class changes it first. No filter reads more than one of these.
constexpr std::string_view kFilterGroup = "Filter";

params::ParamList describeComparisons(FilterParams& p) {
    using params::inGroup;
    return {
        params::integer({"pcf-radius", "PCF radius"}, p.pcfRadius, 0, 15, "texels",
                        "Percentage-closer filtering averages (2 r + 1) x (2 r + 1) comparisons; r is this radius."),
        params::real({"disc-radius", "Disc radius"}, p.discRadius, 0, 32, "texels",
                     "Radius of the disc in which the comparisons are spread."),
        inGroup(kFilterGroup, params::integer({"samples", "Comparisons"}, p.samples, 1, 256, "",
                                              "Filters disc and pcss: depth comparisons for one pixel.")),
        inGroup(kFilterGroup,
                params::choice({"noise", "Random rotation"}, p.noise,
                               {{"texel", "for each texel"}, {"pixel", "for each pixel"}, "none"},
                               "Filters disc and pcss: how the pattern of samples is turned. For each texel: stays on "
                               "the surface; for each pixel: swims when the eye moves (teaching); none: shows bands.")),
        params::real({"light-radius", "Light radius"}, p.lightRadius, 0, 10, "m",
                     "Filter pcss: radius of a light that has no area of its own; of a directional light, at a "
                     "distance of 1 m. It sets how wide penumbrae are."),
        inGroup(kFilterGroup, params::integer({"blocker-samples", "Blocker samples"}, p.blockerSamples, 1, 256, "",
                                              "Filter pcss: depths read in the search for blockers.")),
        inGroup(kFilterGroup, params::real({"widest", "Widest kernel"}, p.widest, 0, 0.45, "",
                                           "Filter pcss: largest radius of the kernel, as a share of the map's side.")),
    };
}

params::ParamList describeMoments(FilterParams& p) {
    using params::inGroup;
    params::ParamList all = {params::integer({"blur-radius", "Blur radius"}, p.blurRadius, 0, 31, "texels",
                                             "Filters vsm to msm: moments are averaged over (2 r + 1) x (2 r + 1) "
                                             "texels once, before the lookup; r is this radius.")};
    params::ParamList rest = {
        params::boolean({"mipmaps", "Mipmaps of moments"}, p.mipmaps,
                        "Filters vsm to msm: read coarser moments where texels are smaller than pixels; not with esm "
                        "in logarithms."),
        params::choice({"moment-format", "Moment format"}, p.momentFormat,
                       {{"32f", "32-bit float"}, {"16f", "16-bit float"}},
                       "Filters vsm to msm: precision of a moment; 16 bits show rounding errors (teaching)."),
        params::real({"least-deviation", "Minimum deviation"}, p.leastDeviation, 0, 0.1, "",
                     "Filters vsm and evsm: lower bound of the standard deviation of depths, as a share of the map's "
                     "range; 0 shows rounding errors (teaching)."),
        params::real({"bleed-reduction", "Light bleeding reduction"}, p.bleedReduction, 0, 0.99, "",
                     "Filters vsm, evsm and msm: visibilities up to this value become 0, larger ones are stretched; 0 "
                     "shows light that bleeds through two surfaces (teaching)."),
        params::real({"esm-exponent", "ESM exponent c"}, p.esmExponent, 0, 400, "",
                     "Filter esm: c in exp(c z), with depth z from 0 to 1 in the map's range."),
        params::boolean({"esm-logarithms", "ESM in logarithms"}, p.esmLogarithms,
                        "Filter esm: store c z, which cannot overflow; false: exp(c z) itself (teaching)."),
        params::choice({"evsm-moments", "EVSM moments"}, p.evsmMoments,
                       {{"2", "positive exponent only"}, {"4", "positive and negative"}},
                       "Filter evsm: moments of exp(c z) alone, or of -exp(-c z) as well: each bleeds light where the "
                       "other does not."),
        params::real({"evsm-exponent", "EVSM positive exponent c"}, p.evsmExponent, 0, 100, "",
                     "Filter evsm: c in exp(c z), with depth z from -1 to 1."),
        params::real({"evsm-negative", "EVSM negative exponent c"}, p.evsmNegative, 0, 100, "",
                     "Filter evsm: c in -exp(-c z), with depth z from -1 to 1."),
        params::boolean(
            {"exponent-limit", "Limit exponents"}, p.exponentLimit,
            "Filters esm and evsm: reduce c to what the moment format can hold; false: infinities (teaching)."),
        params::real({"msm-bias", "MSM moment bias"}, p.msmBias, 0, 0.1, "",
                     "Filter msm: share of constant moments mixed in against rounding, for a blur radius of 1 (wider "
                     "ones take more); a larger share lets more light through."),
    };
    for (params::Param& param : inGroup(kFilterGroup, std::move(rest)))
        all.push_back(std::move(param));
    return all;
}

} // namespace

params::ParamList describe(FilterParams& p) {
    params::ParamList all{params::choice({"filter", "Filter type"}, p.kind, filterChoices(),
                                         "How the depths of several texels become one visibility between 0 and 1.")};
    for (params::ParamList part : {describeComparisons(p), describeMoments(p)})
        for (params::Param& param : part) {
            const auto isRead = [&p, id = param.id] { return filterInfo(p.kind).reads(id); };
            all.push_back(params::onlyIf(isRead, std::move(param)));
        }
    return all;
}

} // namespace shadowlab::shadow_map
