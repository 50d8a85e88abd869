// A traced picture as it is shown: exposed, clamped and encoded as sRGB, on all cores.
//
// Picture adds light by light, in double, to radiance in floats: stages, samples and trees are made of that. Where nothing but the
// picture is wanted, each pixel is shaded here once, in float, and its bytes are uploaded: a fifth of the memory, and no pass that
// encodes. The result differs by one level of 255 at most. No GL here.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/image/image.h"
#include "techniques/ray_tracing/picture.h"

namespace shadowlab::ray_tracing {

class FinishedPicture {
public:
    /// Of radiance, in its order.
    void encode(const Grid<vec3>& radiance, float exposure);
    /// Of what was traced, all lights together, each as a point where it has an area.
    void shade(const Surfaces& surfaces, const Picture& traced);

    /// Row 0 is at the bottom.
    [[nodiscard]] const Grid<image::Color8>& fromBelow() const { return colors_; }

private:
    Grid<image::Color8> colors_;
};

} // namespace shadowlab::ray_tracing
