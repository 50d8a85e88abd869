// SPDX-License-Identifier: MIT
#include "app/foreign/tone_curve.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/image/image.h"

namespace shadowlab::foreign {

namespace {

/// IEC 61966-2-1, in double; its inverse is image::linearFromEncoded.
double srgb(double linear) { return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055; }

} // namespace

std::string_view toText(ToneCurve curve) {
    switch (curve) {
    case ToneCurve::srgb: return "sRGB";
    case ToneCurve::linear: return "linear (gamma 1.0)";
    case ToneCurve::power22: return "gamma 2.2";
    case ToneCurve::doubleSrgb: return "sRGB twice";
    case ToneCurve::decoded: return "decoded as sRGB";
    }
    return "";
}

double encodedWith(ToneCurve curve, double linear) {
    const double light = std::clamp(linear, 0.0, 1.0);
    switch (curve) {
    case ToneCurve::srgb: return srgb(light);
    case ToneCurve::linear: return light;
    case ToneCurve::power22: return std::pow(light, 1 / 2.2);
    case ToneCurve::doubleSrgb: return srgb(srgb(light));
    case ToneCurve::decoded: return image::linearFromEncoded(light);
    }
    return light;
}

double linearFrom(ToneCurve curve, double encoded) {
    const double number = std::clamp(encoded, 0.0, 1.0);
    switch (curve) {
    case ToneCurve::srgb: return image::linearFromEncoded(number);
    case ToneCurve::linear: return number;
    case ToneCurve::power22: return std::pow(number, 2.2);
    case ToneCurve::doubleSrgb: return image::linearFromEncoded(image::linearFromEncoded(number));
    case ToneCurve::decoded: return srgb(number);
    }
    return number;
}

} // namespace shadowlab::foreign
