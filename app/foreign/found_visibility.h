// How much of a light each pixel of a foreign picture sees.
//
// Either the picture says it itself (a visibility image, grey 0 to 255), or it is a shaded picture P beside a reference R that is the same
// without shadows. With D the radiance that the light adds where it is seen, R - P = (1 - visibility) D. D is a share of R: that
// of the scene's own shading, times one number for the whole picture, the median over the pixels that are clearly in shadow. So neither
// brightness nor the strength of ambient light needs to be known, and light that remains in shadow does no harm.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/foreign/expected_light.h"
#include "app/foreign/tone_curve.h"
#include "app/judge/verdict.h"
#include "app/picture/picture.h"
#include "techniques/foundation/image/image.h"

namespace shadowlab::foreign {

/// Lit or in shadow: there is light to be seen or not.
inline bool facesTheLight(trace::Visibility visibility) {
    return visibility == trace::Visibility::lit || visibility == trace::Visibility::shadowed;
}

struct FoundVisibility {
    picture::VisibilityImage image;
    std::vector<std::uint8_t> isJudged{}; ///< per pixel: 0 where the pictures cannot say
    std::vector<std::uint8_t> isSame{};   ///< of a pair, per pixel: 1 where both pictures show the same; empty: no pair
    int notJudged = 0;                  ///< pixels with a surface that faces the light, where they cannot
    int clipped = 0;                    ///< of all, pixels of the reference that are white: brighter light would look the same
    double strength = 1;                ///< of a pair: share of R that D has, over that of the scene's shading
};

/// A picture without transparency has a surface wherever the truth has one.
FoundVisibility fromVisibilityImage(const image::Image& picture, const judge::Truth& truth);

/// What the light adds must be this many levels of 255 of the reference. Below, rounding of both pictures could decide.
constexpr double kLeastLevels = 4;

/// A pixel is not judged where the reference is white in all channels, where it lacks the light that the scene's shading is mostly of (of an object that lacks it as a whole, the light is not seen), or where
/// smooth and flat normals lead to different answers. Where both pictures show the same, a pixel is never in shadow.
FoundVisibility fromPair(const image::Image& shaded, const image::Image& reference, const judge::Truth& truth,
                         const ExpectedLight& expected, ToneCurve curve = ToneCurve::srgb);

/// Of a picture that is taken for a visibility image, the share of pixels that are neither black nor white. A light without area leaves
/// such greys on edges alone; a shaded picture consists of them.
double greyShare(const image::Image& picture, const judge::Truth& truth);

} // namespace shadowlab::foreign
