// Copies a picture from the processor to a texture.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/gl/texture.h"
#include "techniques/foundation/image/image.h"
#include "techniques/ray_tracing/picture.h"

namespace shadowlab::ray_tracing {

/// Writes one texel for each value: toTexel(value) returns a vec2 or a vec4. GL counts rows from the bottom and the picture from
/// the top: rows are flipped here.
template <typename Value, typename ToTexel>
void upload(const gl::Texture2D& texture, const Grid<Value>& grid, ivec2 size, const ToTexel& toTexel) {
    using Texel = decltype(toTexel(grid[0]));
    static_assert(sizeof(Texel) == 8 || sizeof(Texel) == 16, "vec2 or vec4");
    std::vector<Texel> texels(grid.size());
    const auto width = static_cast<std::size_t>(size.x), height = static_cast<std::size_t>(size.y);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
            texels[(height - 1 - y) * width + x] = toTexel(grid[y * width + x]);
    texture.bind(0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, sizeof(Texel) == 8 ? GL_RG : GL_RGBA, GL_FLOAT,
                    texels.data());
}

/// Writes colours whose rows already count from the bottom, without a copy.
inline void uploadFromBelow(const gl::Texture2D& texture, const Grid<vec3>& colors, ivec2 size) {
    texture.bind(0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RGB, GL_FLOAT, colors.data());
}
inline void uploadFromBelow(const gl::Texture2D& texture, const Grid<image::Color8>& colors, ivec2 size) {
    texture.bind(0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, colors.data());
}

} // namespace shadowlab::ray_tracing
