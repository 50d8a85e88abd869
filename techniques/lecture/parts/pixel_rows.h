// A picture that the processor computes, for techniques that trace rays: row by row from the top, with a pause where the time is up.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/gl/texture.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/technique.h"

namespace shadowlab::lecture {

class PixelRows {
public:
    /// From here on nothing of it is computed.
    void restart(ivec2 size) {
        size_ = size;
        rowsDone_ = 0;
        texels_.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), vec4(0.0f));
    }

    /// Goes on with texelAt(pixel) for the pixels of each row (pixel (0, 0) is the upper left one), rows on all cores; at least
    /// one row. True when all rows are done.
    template <typename TexelAt>
    bool advance(Deadline deadline, const TexelAt& texelAt) {
        const auto rows = static_cast<std::size_t>(size_.y), columns = static_cast<std::size_t>(size_.x);
        rowsDone_ = trace::parallelUntil(deadline, rowsDone_, rows, [&](std::size_t row) {
            for (std::size_t x = 0; x < columns; ++x) // OpenGL counts rows from the bottom
                texels_[(rows - 1 - row) * columns + x] = texelAt(ivec2(x, row));
        });
        return rowsDone_ == rows;
    }
    /// 0..1
    [[nodiscard]] double done() const { return static_cast<double>(rowsDone_) / std::max(size_.y, 1); }
    [[nodiscard]] const std::vector<vec4>& texels() const { return texels_; }

    void upload(const gl::Texture2D& texture) const {
        texture.bind(0);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size_.x, size_.y, GL_RGBA, GL_FLOAT, texels_.data());
    }
    /// For a stage: red a value, green 1 where there is one.
    [[nodiscard]] gl::Texture2D asTexture(std::string_view name) const {
        gl::Texture2D texture(GL_RG32F, size_, name);
        upload(texture);
        return texture;
    }
    /// From 0 to its largest value.
    [[nodiscard]] Display scale(std::string unit) const {
        double most = 1;
        for (const vec4& texel : texels_)
            most = std::max(most, static_cast<double>(texel.r));
        return {.minimum = 0, .maximum = most, .unit = std::move(unit), .key = {}};
    }

private:
    ivec2 size_{0};
    std::size_t rowsDone_ = 0;
    std::vector<vec4> texels_;
};

} // namespace shadowlab::lecture
