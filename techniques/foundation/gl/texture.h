// Two-dimensional textures, plain or in layers, that know their size and format.
// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>
#include <vector>

#include "techniques/foundation/gl/handle.h"
#include "techniques/foundation/math/types.h"

namespace shadowlab::gl {

/// GL_TEXTURE_2D without mipmaps, nearest filter, clamped to its edge.
class Texture2D {
public:
    Texture2D() = default;
    /// Throws Error (overLimit) when the size exceeds GL_MAX_TEXTURE_SIZE, naming both.
    Texture2D(GLenum internalFormat, ivec2 size, std::string_view name);
    void bind(int unit) const;
    [[nodiscard]] GLuint id() const { return handle_.id(); }
    [[nodiscard]] ivec2 size() const { return size_; }
    [[nodiscard]] GLenum internalFormat() const { return internalFormat_; }
    explicit operator bool() const { return bool(handle_); }

private:
    TextureHandle handle_;
    ivec2 size_{0};
    GLenum internalFormat_ = 0;
};

/// How a shader reads depths: compared with a reference (sampler2DArrayShadow; GL_LEQUAL: 1 where reference <= stored), one of
/// them or four weighted; or as they are (sampler2DArray).
enum class DepthSampling { compareNearest, compareLinear, depths };

/// GL_TEXTURE_2D_ARRAY of depths: one layer per cascade or per face around a point light. Border depth 1 (lit).
class DepthTextureArray {
public:
    DepthTextureArray() = default;
    DepthTextureArray(GLenum internalFormat, int side, int layers, std::string_view name);
    void bind(int unit) const;
    /// At first compareNearest.
    void sample(DepthSampling how) const;
    /// Beyond the border: as at the edge, or (false, and at first) lit.
    void clampToEdge(bool on) const;
    [[nodiscard]] GLuint id() const { return handle_.id(); }
    [[nodiscard]] int side() const { return side_; }
    [[nodiscard]] int layers() const { return layers_; }
    explicit operator bool() const { return bool(handle_); }

private:
    TextureHandle handle_;
    int side_ = 0, layers_ = 0;
};

/// GL_TEXTURE_2D_ARRAY of whole numbers (GL_R32UI): which triangle a light sees, one layer per map. Read with texelFetch.
class IdTextureArray {
public:
    IdTextureArray() = default;
    IdTextureArray(int side, int layers, std::string_view name);
    void bind(int unit) const;
    [[nodiscard]] GLuint id() const { return handle_.id(); }
    [[nodiscard]] int side() const { return side_; }
    [[nodiscard]] int layers() const { return layers_; }

private:
    TextureHandle handle_;
    int side_ = 0, layers_ = 0;
};

/// GL_TEXTURE_2D_ARRAY of colours, interpolated between texels and, with mipmaps, between their sizes; clamped to its edge.
class ColorTextureArray {
public:
    ColorTextureArray() = default;
    ColorTextureArray(GLenum internalFormat, int side, int layers, bool mipmaps, std::string_view name);
    void bind(int unit) const;
    /// All smaller sizes from the largest, if there are any.
    void makeMipmaps() const;
    [[nodiscard]] GLuint id() const { return handle_.id(); }
    [[nodiscard]] int side() const { return side_; }
    [[nodiscard]] int layers() const { return layers_; }
    [[nodiscard]] GLenum internalFormat() const { return internalFormat_; }

private:
    TextureHandle handle_;
    int side_ = 0, layers_ = 0;
    GLenum internalFormat_ = 0;
    bool mipmaps_ = false;
};

/// Numbers that a shader reads by index (shaders/table.glsl): four to a texel, floats (sampler2D) or whole (usampler2D).
class TableTexture {
public:
    TableTexture() = default;
    /// Throws Error (overLimit) when there are more rows of them than GL_MAX_TEXTURE_SIZE.
    TableTexture(const std::vector<vec4>& texels, std::string_view name);
    TableTexture(const std::vector<uvec4>& texels, std::string_view name);
    void bind(int unit) const;

private:
    TableTexture(GLenum format, const void* texels, std::size_t count, std::string_view name);
    TextureHandle handle_;
};

/// Values of the triangles of a scene that a shader reads by index.
class TriangleTexture {
public:
    TriangleTexture() = default;
    /// A byte each (isamplerBuffer over GL_R8I), or two words (usamplerBuffer over GL_RG32UI). Throw Error (overLimit) when there are
    /// more than GL_MAX_TEXTURE_BUFFER_SIZE.
    TriangleTexture(const std::vector<std::int8_t>& bytes, std::string_view name);
    TriangleTexture(const std::vector<uvec2>& words, std::string_view name);
    void bind(int unit) const;

private:
    TriangleTexture(GLenum format, const void* data, std::size_t count, std::size_t bytesEach, std::string_view name);
    BufferHandle buffer_;
    TextureHandle handle_;
};

} // namespace shadowlab::gl
