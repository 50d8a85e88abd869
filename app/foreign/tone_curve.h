// How a picture's numbers stand for light: the curves that renderers write by default or by mistake.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <string_view>

namespace shadowlab::foreign {

enum class ToneCurve {
    srgb,       ///< IEC 61966-2-1, as a picture should be
    linear,     ///< the numbers are light: not encoded at all
    power22,    ///< light to the power of 1/2.2
    doubleSrgb, ///< sRGB of sRGB: encoded twice
    decoded,    ///< decoded where it should have been encoded
};
inline constexpr std::array kToneCurves{ToneCurve::srgb, ToneCurve::linear, ToneCurve::power22, ToneCurve::doubleSrgb, ToneCurve::decoded};

/// "sRGB", "linear (gamma 1.0)" ...
std::string_view toText(ToneCurve curve);

/// Both between 0 and 1; the encoder clamps.
double encodedWith(ToneCurve curve, double linear);
double linearFrom(ToneCurve curve, double encoded);

} // namespace shadowlab::foreign
