// Framebuffer objects; the program never draws to the default framebuffer.
// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>

#include "techniques/foundation/gl/handle.h"
#include "techniques/foundation/gl/texture.h"

namespace shadowlab::gl {

/// One colour texture and, if wanted, one depth-stencil texture. The textures must outlive it.
class Framebuffer {
public:
    Framebuffer() = default;
    /// Either may be null. Throws std::logic_error spelling out why it is incomplete.
    Framebuffer(const Texture2D* color, const Texture2D* depthStencil, std::string_view name);
    /// Two colours that one shader writes, outputs 0 and 1, with depth and stencil.
    Framebuffer(const Texture2D& first, const Texture2D& second, const Texture2D& depthStencil, std::string_view name);
    /// Depth only, into one layer.
    Framebuffer(const DepthTextureArray& depth, int layer, std::string_view name);
    /// The same with a layer of numbers beside it.
    Framebuffer(const IdTextureArray& ids, const DepthTextureArray& depth, int layer, std::string_view name);
    /// One layer of colours, without depth.
    Framebuffer(const ColorTextureArray& color, int layer, std::string_view name);
    /// Binds it for drawing and sets the viewport to its size.
    void bind() const;
    [[nodiscard]] GLuint id() const { return handle_.id(); }
    [[nodiscard]] ivec2 size() const { return size_; }
    explicit operator bool() const { return bool(handle_); }

private:
    void requireComplete(std::string_view name) const;
    FramebufferHandle handle_;
    ivec2 size_{0};
};

/// A linear RGBA16F picture with a 24-bit depth and an 8-bit stencil buffer: what techniques render into.
struct Target {
    Texture2D color, depthStencil;
    Framebuffer framebuffer;
    /// The same without the colour, for passes that only count or only write depth. Masking the colour off is not the same:
    /// a software renderer still loads, blends and stores what is masked, which was a third of the time of counting.
    Framebuffer withoutColor;
    Target() = default;
    Target(ivec2 size, std::string_view name)
        : color(GL_RGBA16F, size, name), depthStencil(GL_DEPTH24_STENCIL8, size, name),
          framebuffer(&color, &depthStencil, name), withoutColor(nullptr, &depthStencil, name) {}
    [[nodiscard]] ivec2 size() const { return color.size(); }
};

/// A picture ready to be shown: exposed, clamped and encoded as sRGB, 8 bits a channel. `inShadow` is the same picture as if the
/// light were hidden everywhere, of which a technique that decides after shading copies pixels; of several lights it is a bit for
/// each that is hidden. Both are empty until somebody draws.
struct FinishedPicture {
    Texture2D color, inShadow;
};

} // namespace shadowlab::gl
