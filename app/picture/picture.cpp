// SPDX-License-Identifier: MIT
#include "app/picture/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/read_back.h"

namespace shadowlab::picture {

namespace {

gl::Program encoderOf(std::vector<std::string> what) {
    return {"fullscreen.vert", "picture/encode.frag", std::move(what)};
}

} // namespace

PictureEncoder::PictureEncoder()
    : radiance_(encoderOf({"RADIANCE"})), oneSample_(encoderOf({"RADIANCE", "ONE_SAMPLE"})),
      ground_(encoderOf({"GROUND"})), swatches_(encoderOf({"SWATCHES"})), palette_(encoderOf({"PALETTE"})),
      count_(encoderOf({"COUNT"})),
      visibility_(encoderOf({"VISIBILITY"})) {}

gl::Texture2D PictureEncoder::encodeInPlace(const gl::Texture2D& radiance, float exposure, int supersample,
                                            const Region& region, gl::Texture2D old) const {
    const gl::Program& program = supersample == 1 ? oneSample_ : radiance_;
    program.use();
    program.set("exposure", exposure);
    return draw(program, radiance, supersample, region, std::move(old));
}

void PictureEncoder::finish(gl::FinishedPicture& picture, const gl::Target& target, const Frame::Result& frame,
                            float exposure, const Region& region) const {
    if (!frame.isFinished)
        picture.color = encodeInPlace(target.color, exposure, 1, region, std::move(picture.color));
}

gl::Texture2D PictureEncoder::encodeInPlace(const Stage& stage, StageKind kind, float exposure, int supersample,
                                            const gl::Texture2D* ground) const {
    // A stage may have a size of its own (a shadow map's view of the scene): only those of the target's are
    // supersampled.
    switch (kind) {
    case StageKind::radiance: return encodeInPlace(stage.texture, exposure, supersample);
    case StageKind::swatches: return draw(swatches_, stage.texture, supersample, {});
    case StageKind::visibility: return draw(visibility_, stage.texture, supersample, {});
    case StageKind::scalar:
    case StageKind::count: break;
    }
    const look::Palette& palette = paletteOf(kind);
    std::array<vec4, std::tuple_size_v<look::Palette>> stops;
    std::ranges::transform(palette, stops.begin(), [](const vec3& color) { return vec4(color, 1); });
    const bool isOnGround = kind == StageKind::count && ground && ground->size() == stage.texture.size();
    const gl::Program& program = isOnGround ? count_ : palette_;
    program.use();
    program.set("minimum", static_cast<float>(stage.display.minimum));
    program.set("maximum", static_cast<float>(stage.display.maximum));
    program.set("palette", std::span<const vec4>(stops));
    if (isOnGround) {
        constexpr int kGroundUnit = 1; // 0 is the source
        program.set("exposure", exposure);
        program.set("ground", kGroundUnit);
        ground->bind(kGroundUnit);
        glActiveTexture(GL_TEXTURE0); // the picture that draw() makes is bound where it is made
    }
    return draw(program, stage.texture, supersample, {});
}

gl::Texture2D PictureEncoder::encodeGround(const gl::Texture2D& radiance, float exposure, const Region& region) const {
    ground_.use();
    ground_.set("exposure", exposure);
    return draw(ground_, radiance, 1, region);
}

image::Image PictureEncoder::encode(const gl::Texture2D& radiance, float exposure, int supersample) const {
    return read(encodeInPlace(radiance, exposure, supersample));
}

image::Image PictureEncoder::encode(const Stage& stage, StageKind kind, float exposure, int supersample,
                                    const gl::Texture2D* ground) const {
    return read(encodeInPlace(stage, kind, exposure, supersample, ground));
}

gl::Texture2D PictureEncoder::draw(const gl::Program& program, const gl::Texture2D& source, int supersample,
                                   const Region& region, gl::Texture2D old) {
    const ivec2 size = source.size() / supersample;
    gl::Texture2D encoded =
        old && old.size() == size ? std::move(old) : gl::Texture2D(GL_RGBA8, size, "encoded picture");
    const gl::Framebuffer framebuffer(&encoded, nullptr, "encoded picture");
    gl::setBaselineState();
    glDisable(GL_DEPTH_TEST);
    framebuffer.bind();
    if (region.size.x > 0 && region.size.y > 0) {
        glEnable(GL_SCISSOR_TEST); // GL counts rows from below
        glScissor(region.corner.x, size.y - region.corner.y - region.size.y, region.size.x, region.size.y);
    }
    program.use();
    program.set("supersample", supersample);
    program.set("source", 0);
    source.bind(0);
    gl::drawFullscreenTriangle();
    gl::check("encode");
    return encoded;
}

image::Image PictureEncoder::read(const gl::Texture2D& encoded) {
    const std::vector<glm::u8vec4> texels = gl::readRows<glm::u8vec4>(encoded, GL_UNSIGNED_BYTE);
    image::Image picture(encoded.size().x, encoded.size().y);
    std::memcpy(picture.rgba.data(), texels.data(), texels.size() * 4);
    return picture;
}

gl::Texture2D PictureEncoder::copyOf(const gl::Texture2D& encoded) {
    const ivec2 size = encoded.size();
    gl::Texture2D copy(encoded.internalFormat(), size, "copy of a picture");
    const gl::Framebuffer source(&encoded, nullptr, "copied"), destination(&copy, nullptr, "copy");
    gl::setBaselineState();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, destination.id());
    glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    return copy;
}

bool hasScale(StageKind kind) { return kind == StageKind::scalar || kind == StageKind::count; }

const look::Palette& paletteOf(StageKind kind) { return kind == StageKind::count ? look::diverging() : look::viridis(); }

VisibilityImage readVisibility(const Stage& stage, const Region& region) {
    const auto [corner, size] = judge::shownPart(region, stage.texture.size());
    VisibilityImage visibility{size.x, size.y, {}};
    visibility.greyAlpha.reserve(2 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    for (const vec4& texel : gl::readTexels(stage.texture, corner, size)) {
        const bool covered = texel.g > 0.5f;
        visibility.greyAlpha.push_back(covered ? static_cast<std::uint8_t>(std::lround(255.0f * texel.r)) : 0);
        visibility.greyAlpha.push_back(covered ? 255 : 0);
    }
    return visibility;
}

judge::Grid<float> readTexelSizes(const Stage& stage) {
    const ivec2 size = stage.texture.size();
    judge::Grid<float> sizes(size.x, size.y);
    std::ranges::transform(gl::readTexels(stage.texture), sizes.values.begin(),
                           [](const vec4& texel) { return texel.g > 0.5f ? texel.r : 0.0f; });
    return sizes;
}

} // namespace shadowlab::picture
