// From a slot's target, or a published stage, to a finished picture: exposure, clamp and sRGB encoding, once.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "app/judge/grid.h"
#include "app/judge/verdict.h"
#include "techniques/foundation/base/look.h"
#include "techniques/foundation/image/image.h"
#include "techniques/frame.h"

namespace shadowlab::picture {

/// Encodes on the graphics card and reads back. Needs a current GL context.
class PictureEncoder {
public:
    PictureEncoder();

    /// The radiance in a target: exposure, clamp, sRGB. `supersample` N averages N x N texels in linear light first.
    [[nodiscard]] image::Image encode(const gl::Texture2D& radiance, float exposure, int supersample = 1) const;
    /// The same, left on the graphics card: the cost of a frame that is only shown. Outside of a region that
    /// is not empty nothing is written. `old`: a picture that is no longer needed, to be drawn over if it has the size.
    [[nodiscard]] gl::Texture2D encodeInPlace(const gl::Texture2D& radiance, float exposure, int supersample = 1,
                                              const Region& region = {}, gl::Texture2D old = {}) const;
    /// Makes `picture.color` the frame as it is shown: encodes the radiance in the target, unless the frame has drawn finished pixels.
    void finish(gl::FinishedPicture& picture, const gl::Target& target, const Frame::Result& frame, float exposure,
                const Region& region = {}) const;
    /// `ground`: the finished picture's radiance, on which counts are painted; null, or of another size: they stand alone.
    [[nodiscard]] gl::Texture2D encodeInPlace(const Stage& stage, StageKind kind, float exposure, int supersample = 1,
                                              const gl::Texture2D* ground = nullptr) const;

    /// The picture without its colours, its shadows lifted: the ground on which wrong pixels are shown (verdict_panels.h).
    [[nodiscard]] gl::Texture2D encodeGround(const gl::Texture2D& radiance, float exposure, const Region& region) const;

    /// A stage, encoded according to its kind: exposure, a palette, or the colours as they are.
    [[nodiscard]] image::Image encode(const Stage& stage, StageKind kind, float exposure, int supersample = 1,
                                      const gl::Texture2D* ground = nullptr) const;

    /// What was encoded, on the processor; and once more on the card.
    [[nodiscard]] static image::Image read(const gl::Texture2D& encoded);
    [[nodiscard]] static gl::Texture2D copyOf(const gl::Texture2D& encoded);

private:
    [[nodiscard]] static gl::Texture2D draw(const gl::Program& program, const gl::Texture2D& source, int supersample,
                                            const Region& region, gl::Texture2D old = {});
    gl::Program radiance_, oneSample_, ground_, swatches_, palette_, count_,
        visibility_; ///< shaders/picture/encode.frag, of each kind
};

/// Do the stage's colours stand for numbers on a scale?
bool hasScale(StageKind kind);
/// The colours of that scale, from the least value to the greatest. Counts differ on either side of 0; other numbers rise.
const look::Palette& paletteOf(StageKind kind);

/// Grey and alpha, two bytes a pixel, row 0 on top: 255 x the visible fraction; alpha 255 where there is a surface.
struct VisibilityImage {
    int width = 0, height = 0;
    std::vector<std::uint8_t> greyAlpha;
    [[nodiscard]] std::uint8_t grey(int x, int y) const { return greyAlpha[2 * index(x, y)]; }
    [[nodiscard]] std::uint8_t alpha(int x, int y) const { return greyAlpha[2 * index(x, y) + 1]; }

private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};
/// The whole stage, or only the pixels of a region.
VisibilityImage readVisibility(const Stage& stage, const Region& region = {});

/// How many pixels a texel of a shadow map covers, for each pixel of a stage `texel-size`; 0 where it does not say.
judge::Grid<float> readTexelSizes(const Stage& stage);

} // namespace shadowlab::picture
