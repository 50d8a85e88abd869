// With which curve a picture was encoded, and which way up it lies, as far as its own shading tells: brightness falls off with distance and angle as the scene says,
// and a wrong curve bends that.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "app/foreign/calibration_reading.h"
#include "app/foreign/expected_light.h"
#include "app/foreign/tone_curve.h"
#include "techniques/foundation/image/image.h"

namespace shadowlab::foreign {

struct SeenEncoding {
    ToneCurve curve = ToneCurve::srgb; ///< that agrees best
    double levels = 0;                 ///< of 255: the middle of its differences
    double levelsOfRight = 0;          ///< the same of the curve that should be
};

/// Of a reference without shadows, at any exposure. Nothing where its brightness hardly varies, or where no curve is clearly better
/// than sRGB: then the shading differs, or all is right.
std::optional<SeenEncoding> wrongEncodingOf(const image::Image& reference, const ExpectedLight& expected);

/// Of a visibility image of a light with an area, by its penumbras. A visibility image is not encoded: the right curve is `linear`.
std::optional<SeenEncoding> wrongEncodingOf(const image::Image& visibility, const judge::Truth& truth);

/// How a reference without shadows lies: the orientation in which its brightness agrees best with the scene's shading. Nothing where
/// none agrees clearly better than the others.
std::optional<Orientation> orientationOf(const image::Image& reference, const ExpectedLight& expected, const vec3& background);

} // namespace shadowlab::foreign
