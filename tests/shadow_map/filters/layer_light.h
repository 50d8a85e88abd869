// Pictures of stacked layers, drawn with nothing but a filter of moments, and how far they are from a closed form.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>

#include "tests/shadow_map/filters/stacked_layers.h"
#include "tests/support/light_shares.h"

namespace shadowlab::testing {

// A kernel of 15 x 15: a step of a fifteenth from texel to texel.
inline constexpr int kLayerResolution = 256, kLayerBlurRadius = 7;

/// Just the filter: no offset against acne, which there is none of here, and nothing done about bleeding.
inline std::vector<std::string> bare(const std::string& filter, const std::vector<std::string>& more = {}) {
    std::vector<std::string> settings = {"filter=" + filter,  "resolution=" + std::to_string(kLayerResolution),
                                         "fit=scene",         "blur-radius=" + std::to_string(kLayerBlurRadius),
                                         "mipmaps=false",     "bleed-reduction=0",
                                         "least-deviation=0", "bias-mode=constant",
                                         "constant-bias=0",   "depth-format=32f"};
    settings.insert(settings.end(), more.begin(), more.end());
    return settings;
}

inline StackedLayers layers(const StackedLayers::Shape& shape) { return {shape, kLayerResolution, kLayerBlurRadius}; }

/// How far a picture of layer C is from what the share of A in the kernel says, and in how many pixels that was told.
struct Deviation {
    double largest = 0;
    int mixed = 0; ///< pixels whose kernels hold both
};
inline Deviation deviation(const LightShares& shares, const StackedLayers& stack,
                           const std::function<double(double p)>& expected) {
    Deviation result;
    for (int y = 0; y < StackedLayers::kSize.y; ++y)
        for (int x = 0; x < StackedLayers::kSize.x; ++x) {
            const double p = stack.share(x);
            result.mixed += p > 0 && p < 1;
            result.largest = std::max(result.largest, std::abs(asNumber(shares.at(x, y)) - expected(p)));
        }
    return result;
}

} // namespace shadowlab::testing
