// Reads the texels of a texture back to the processor.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <vector>

#include "techniques/foundation/gl/debug.h"
#include "techniques/foundation/gl/framebuffer.h"

namespace shadowlab::gl {

/// GL counts rows from the bottom, pictures from the top: this is the only place that flips them.
template <typename Texel>
void turnRowsOver(std::vector<Texel>& texels, ivec2 size) {
    for (int y = 0; y < size.y / 2; ++y)
        std::swap_ranges(texels.begin() + std::ptrdiff_t(y) * size.x, texels.begin() + std::ptrdiff_t(y + 1) * size.x,
                         texels.begin() + std::ptrdiff_t(size.y - 1 - y) * size.x);
}

/// Four channels a pixel, row 0 on top, of a rectangle of the texture; `corner` is its upper left one. `type` is the GL
/// type of Texel's components.
template <typename Texel>
std::vector<Texel> readRows(const Texture2D& texture, GLenum type, ivec2 corner, ivec2 size) {
    const Framebuffer framebuffer(&texture, nullptr, "read-back");
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.id());
    std::vector<Texel> texels(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(corner.x, texture.size().y - corner.y - size.y, size.x, size.y, GL_RGBA, type, texels.data());
    check("read-back");
    turnRowsOver(texels, size);
    return texels;
}
template <typename Texel>
std::vector<Texel> readRows(const Texture2D& texture, GLenum type) {
    return readRows<Texel>(texture, type, ivec2(0), texture.size());
}

inline std::vector<vec4> readTexels(const Texture2D& texture) { return readRows<vec4>(texture, GL_FLOAT); }
inline std::vector<vec4> readTexels(const Texture2D& texture, ivec2 corner, ivec2 size) {
    return readRows<vec4>(texture, GL_FLOAT, corner, size);
}

} // namespace shadowlab::gl
