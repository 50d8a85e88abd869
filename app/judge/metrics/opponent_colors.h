// Colours as the eye keeps them apart: lightness, red against green, yellow against blue.
//
// The two spaces that FLIP computes in. YCxCz is linear in light, so that a blur in it is a blur of light; L*a*b* is not,
// so that distances in it are distances that are seen. White is that of sRGB (D65).
// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "techniques/foundation/math/types.h"

namespace shadowlab::judge {

/// Linear RGB of sRGB's primaries to CIE XYZ (IEC 61966-2-1), to the digits that follow from the primaries.
inline vec3 xyzFromLinear(const vec3& rgb) {
    return {0.4123907993f * rgb.r + 0.3575843394f * rgb.g + 0.1804807884f * rgb.b,
            0.2126390059f * rgb.r + 0.7151686788f * rgb.g + 0.0721923154f * rgb.b,
            0.0193308187f * rgb.r + 0.1191947798f * rgb.g + 0.9505321522f * rgb.b};
}
inline vec3 linearFromXyz(const vec3& xyz) {
    return {3.2409699419f * xyz.x - 1.5373831776f * xyz.y - 0.4986107603f * xyz.z,
            -0.9692436363f * xyz.x + 1.8759675015f * xyz.y + 0.0415550574f * xyz.z,
            0.0556300797f * xyz.x - 0.2039769589f * xyz.y + 1.0569715142f * xyz.z};
}
inline const vec3 kWhiteXyz = xyzFromLinear(vec3(1.0f));

/// Luminance, red-green and blue-yellow, linear in light. White is (100, 0, 0), black (-16, 0, 0).
inline vec3 ycxczFromLinear(const vec3& rgb) {
    const vec3 t = xyzFromLinear(rgb) / kWhiteXyz;
    return {116.0f * t.y - 16.0f, 500.0f * (t.x - t.y), 200.0f * (t.y - t.z)};
}
inline vec3 linearFromYcxcz(const vec3& ycxcz) {
    const float y = (ycxcz.x + 16.0f) / 116.0f;
    return linearFromXyz(vec3(y + ycxcz.y / 500.0f, y, y - ycxcz.z / 200.0f) * kWhiteXyz);
}

/// CIE L*a*b* (1976).
inline vec3 labFromLinear(const vec3& rgb) {
    const auto root = [](float t) {
        constexpr float delta = 6.0f / 29.0f;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3.0f * delta * delta) + 4.0f / 29.0f;
    };
    const vec3 t = xyzFromLinear(rgb) / kWhiteXyz;
    const vec3 f(root(t.x), root(t.y), root(t.z));
    return {116.0f * f.y - 16.0f, 500.0f * (f.x - f.y), 200.0f * (f.y - f.z)};
}

/// Colours of dark things are seen less (Hunt, 1952): a and b shrink with lightness.
inline vec3 huntAdjusted(const vec3& lab) { return {lab.x, 0.01f * lab.x * lab.y, 0.01f * lab.x * lab.z}; }

/// Lightness counted apart, hue and chroma as a distance. Abasi, Tehran and Fairchild, "Distance metrics for very large
/// color differences", Color Research and Application 45(2), 2020.
inline float hyab(const vec3& p, const vec3& q) { return std::abs(p.x - q.x) + std::hypot(p.y - q.y, p.z - q.z); }

} // namespace shadowlab::judge
