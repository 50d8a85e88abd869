// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/filters/filter_params.h"

#include "techniques/shadow_map/filters/filters.h"

namespace shadowlab::shadow_map {

namespace {

/// "hard: one comparison a pixel; hw2x2: four, weighted; ...": of the table, in its order.
std::string whatFiltersDo() {
    std::string text;
    for (const FilterInfo& filter : filters()) {
        text += filter.name;
        if (filter.what.empty())
            text += ", ";
        else
            text += ": " + std::string(filter.what) + (&filter == &filters().back() ? "." : "; ");
    }
    return text;
}

std::vector<std::string> filterNames() {
    std::vector<std::string> names;
    for (const FilterInfo& filter : filters())
        names.emplace_back(filter.name);
    return names;
}

params::ParamList describeComparisons(FilterParams& p) {
    return {
        params::integer("pcf-radius", p.pcfRadius, 0, 15, "texels", "PCF averages (2 r + 1) x (2 r + 1) comparisons."),
        params::real("disc-radius", p.discRadius, 0, 32, "texels", "filter disc: radius of the disc."),
        params::integer("samples", p.samples, 1, 256, "", "disc and pcss: comparisons for one pixel."),
        params::choice("noise", p.noise, {"texel", "pixel", "none"},
                       "disc and pcss turn their samples by chance: once for each texel, which stays on the surface; "
                       "for each pixel, which swims when the eye moves (teaching); not at all, which shows bands."),
        params::real("light-radius", p.lightRadius, 0, 10, "m",
                     "pcss: half width of a light that has no area of its own; of a directional light, at a distance "
                     "of 1 m."),
        params::integer("blocker-samples", p.blockerSamples, 1, 256, "", "pcss: depths that the search looks at."),
        params::real("widest", p.widest, 0, 0.45, "",
                     "pcss: no kernel is wider to one side than this share of the map."),
    };
}

params::ParamList describeMoments(FilterParams& p) {
    return {
        params::integer("blur-radius", p.blurRadius, 0, 31, "texels",
                        "vsm to msm: the moments are averaged over (2 r + 1) x (2 r + 1) texels, once."),
        params::boolean("mipmaps", p.mipmaps,
                        "vsm to msm: coarser moments where texels are smaller than pixels (not for logarithms)."),
        params::choice("moment-format", p.momentFormat, {"32f", "16f"},
                       "vsm to msm: bits of a moment; 16f shows what rounding does to them (teaching)."),
        params::real("least-deviation", p.leastDeviation, 0, 0.1, "",
                     "vsm and evsm: depths are taken to vary by at least this share of the map's range; 0 shows what "
                     "rounding does (teaching)."),
        params::real("bleed-reduction", p.bleedReduction, 0, 0.99, "",
                     "vsm, evsm and msm: what is no more lit than this is dark; 0 shows the light that bleeds through "
                     "two surfaces (teaching)."),
        params::real("esm-exponent", p.esmExponent, 0, 400, "",
                     "esm: c in exp(c z), z from 0 to 1 in the map's range."),
        params::boolean("esm-logarithms", p.esmLogarithms,
                        "esm: keep c z instead of exp(c z), which overflows; false: exp(c z) itself (teaching)."),
        params::choice("evsm-moments", p.evsmMoments, {"2", "4"},
                       "evsm: of the positive exponential alone, or of the negative one as well, which leaks where the "
                       "other does not."),
        params::real("evsm-exponent", p.evsmExponent, 0, 100, "", "evsm: c in exp(c z), z from -1 to 1."),
        params::real("evsm-negative", p.evsmNegative, 0, 100, "", "evsm: c in -exp(-c z)."),
        params::boolean("exponent-limit", p.exponentLimit,
                        "esm and evsm: no exponent larger than the format can hold; false: infinities (teaching)."),
        params::real("msm-bias", p.msmBias, 0, 0.1, "",
                     "msm: share of moments that no depths can have, against rounding in a kernel of "
                     "radius 1 (wider ones take more of it); more lets light through."),
    };
}

} // namespace

params::ParamList describe(FilterParams& p) {
    params::ParamList all{params::choice("filter", p.kind, filterNames(), whatFiltersDo())};
    for (params::ParamList part : {describeComparisons(p), describeMoments(p)})
        for (params::Param& param : part) {
            const auto isRead = [&p, id = param.id] { return filterInfo(p.kind).reads(id); };
            all.push_back(params::onlyIf(isRead, std::move(param)));
        }
    return all;
}

} // namespace shadowlab::shadow_map
