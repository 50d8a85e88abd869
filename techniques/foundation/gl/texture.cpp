// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/texture.h"

#include <string>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/gl/debug.h"

namespace shadowlab::gl {

namespace {

/// A pixel transfer format that fits the internal format; no pixels are transferred, but GL requires a legal pair.
std::pair<GLenum, GLenum> transferFormat(GLenum internalFormat) {
    switch (internalFormat) {
    case GL_DEPTH24_STENCIL8: return {GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8};
    case GL_DEPTH_COMPONENT16:
    case GL_DEPTH_COMPONENT24:
    case GL_DEPTH_COMPONENT32F: return {GL_DEPTH_COMPONENT, GL_FLOAT};
    case GL_R32UI: return {GL_RED_INTEGER, GL_UNSIGNED_INT};
    default: return {GL_RGBA, GL_FLOAT};
    }
}

/// Of one texel, without mipmaps. 24 bits of depth are kept in 32.
std::int64_t texelBytes(GLenum internalFormat) {
    switch (internalFormat) {
    case GL_R8: return 1;
    case GL_DEPTH_COMPONENT16:
    case GL_R16F:
    case GL_RG8: return 2;
    case GL_RGBA16F:
    case GL_RG32F: return 8;
    case GL_RGBA32F:
    case GL_RGBA32UI: return 16;
    default: return 4;
    }
}

/// Of the rows that tables lie in, shaders/table.glsl: a power of two. OpenGL 3.3 promises 1024, its drivers have 8192 and more; a
/// wide row leaves as many rows as there are for large tables, and costs a small one 64 kB.
constexpr GLint kTableWidth = 4096;

void requireSize(GLint limit, int wanted, std::string_view what) {
    if (wanted > limit)
        throw Error(ExitStatus::overLimit, std::string(what) + " needs " + std::to_string(wanted) +
                                               " texels on a side, this OpenGL driver allows " + std::to_string(limit) +
                                               "; choose a smaller size");
}

/// After a texture of layers was made.
void requireMemory(int side, int layers, std::string_view name) {
    if (glGetError() == GL_OUT_OF_MEMORY)
        throw Error(ExitStatus::overLimit, std::string(name) + ": no memory for " + std::to_string(layers) +
                                               " layers of " + std::to_string(side) + " x " + std::to_string(side) +
                                               " texels; choose a smaller resolution");
}

GLint limitOf(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

void sampleNearestClamped(GLenum target) {
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

} // namespace

Texture2D::Texture2D(GLenum internalFormat, ivec2 size, std::string_view name)
    : handle_(TextureHandle::create()), size_(size), internalFormat_(internalFormat) {
    requireSize(limitOf(GL_MAX_TEXTURE_SIZE), std::max(size.x, size.y), name);
    glBindTexture(GL_TEXTURE_2D, handle_.id());
    const auto [format, type] = transferFormat(internalFormat);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), size.x, size.y, 0, format, type, nullptr);
    handle_.holds(texelBytes(internalFormat) * size.x * size.y);
    sampleNearestClamped(GL_TEXTURE_2D);
    label(GL_TEXTURE, handle_.id(), name);
    if (glGetError() == GL_OUT_OF_MEMORY)
        throw Error(ExitStatus::overLimit, std::string(name) + ": no memory for " + std::to_string(size.x) + " x " +
                                               std::to_string(size.y) + " texels; choose a smaller size");
}

void Texture2D::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, handle_.id());
}

DepthTextureArray::DepthTextureArray(GLenum internalFormat, int side, int layers, std::string_view name)
    : handle_(TextureHandle::create()), side_(side), layers_(layers) {
    requireSize(limitOf(GL_MAX_TEXTURE_SIZE), side, name);
    glBindTexture(GL_TEXTURE_2D_ARRAY, handle_.id());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(internalFormat), side, side, layers, 0, GL_DEPTH_COMPONENT,
                 GL_FLOAT, nullptr);
    handle_.holds(texelBytes(internalFormat) * side * side * layers);
    sampleNearestClamped(GL_TEXTURE_2D_ARRAY);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    const float lit[4] = {1, 1, 1, 1}; // outside of the map the depth is the largest: lit
    glTexParameterfv(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BORDER_COLOR, lit);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    sample(DepthSampling::compareNearest);
    label(GL_TEXTURE, handle_.id(), name);
    requireMemory(side, layers, name);
}

void DepthTextureArray::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D_ARRAY, handle_.id());
}

void DepthTextureArray::sample(DepthSampling how) const {
    glBindTexture(GL_TEXTURE_2D_ARRAY, handle_.id());
    const bool depths = how == DepthSampling::depths;
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, depths ? GL_NONE : GL_COMPARE_REF_TO_TEXTURE);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D_ARRAY, filter, how == DepthSampling::compareLinear ? GL_LINEAR : GL_NEAREST);
}

void DepthTextureArray::clampToEdge(bool on) const {
    glBindTexture(GL_TEXTURE_2D_ARRAY, handle_.id());
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D_ARRAY, axis, on ? GL_CLAMP_TO_EDGE : GL_CLAMP_TO_BORDER);
}

IdTextureArray::IdTextureArray(int side, int layers, std::string_view name)
    : handle_(TextureHandle::create()), side_(side), layers_(layers) {
    requireSize(limitOf(GL_MAX_TEXTURE_SIZE), side, name);
    glBindTexture(GL_TEXTURE_2D_ARRAY, handle_.id());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_R32UI, side, side, layers, 0, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    handle_.holds(texelBytes(GL_R32UI) * side * side * layers);
    sampleNearestClamped(GL_TEXTURE_2D_ARRAY);
    label(GL_TEXTURE, handle_.id(), name);
    requireMemory(side, layers, name);
}

void IdTextureArray::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D_ARRAY, handle_.id());
}

ColorTextureArray::ColorTextureArray(GLenum internalFormat, int side, int layers, bool mipmaps, std::string_view name)
    : handle_(TextureHandle::create()), side_(side), layers_(layers), internalFormat_(internalFormat),
      mipmaps_(mipmaps) {
    requireSize(limitOf(GL_MAX_TEXTURE_SIZE), side, name);
    glBindTexture(GL_TEXTURE_2D_ARRAY, handle_.id());
    const auto [format, type] = transferFormat(internalFormat);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(internalFormat), side, side, layers, 0, format, type,
                 nullptr);
    const std::int64_t base = texelBytes(internalFormat) * side * side * layers;
    handle_.holds(mipmaps ? base * 4 / 3 : base); // a quarter of a level for the next one
    sampleNearestClamped(GL_TEXTURE_2D_ARRAY);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, mipmaps ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    label(GL_TEXTURE, handle_.id(), name);
    requireMemory(side, layers, name);
}

void ColorTextureArray::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D_ARRAY, handle_.id());
}

void ColorTextureArray::makeMipmaps() const {
    if (!mipmaps_) return;
    glBindTexture(GL_TEXTURE_2D_ARRAY, handle_.id());
    glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
}

TableTexture::TableTexture(const std::vector<vec4>& texels, std::string_view name)
    : TableTexture(GL_RGBA32F, texels.data(), texels.size(), name) {}

TableTexture::TableTexture(const std::vector<uvec4>& texels, std::string_view name)
    : TableTexture(GL_RGBA32UI, texels.data(), texels.size(), name) {}

TableTexture::TableTexture(GLenum format, const void* texels, std::size_t count, std::string_view name)
    : handle_(TextureHandle::create()) {
    const auto rows = static_cast<int>(std::max<std::size_t>(1, (count + kTableWidth - 1) / kTableWidth));
    requireSize(limitOf(GL_MAX_TEXTURE_SIZE), std::max(kTableWidth, rows), name);
    glBindTexture(GL_TEXTURE_2D, handle_.id());
    const GLenum transfer = format == GL_RGBA32UI ? GL_RGBA_INTEGER : GL_RGBA;
    const GLenum type = format == GL_RGBA32UI ? GL_UNSIGNED_INT : GL_FLOAT;
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), kTableWidth, rows, 0, transfer, type, nullptr);
    handle_.holds(texelBytes(format) * kTableWidth * rows);
    sampleNearestClamped(GL_TEXTURE_2D);
    const auto whole = static_cast<GLsizei>(count / kTableWidth), rest = static_cast<GLsizei>(count % kTableWidth);
    const auto* const bytes = static_cast<const char*>(texels);
    if (whole > 0) glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kTableWidth, whole, transfer, type, bytes);
    if (rest > 0)
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, whole, rest, 1, transfer, type,
                        bytes +
                            static_cast<std::size_t>(texelBytes(format)) * (count - static_cast<std::size_t>(rest)));
    label(GL_TEXTURE, handle_.id(), name);
    if (glGetError() == GL_OUT_OF_MEMORY)
        throw Error(ExitStatus::overLimit,
                    std::string(name) + ": no memory for " + std::to_string(count) + " texels; use a simpler mesh");
}

void TableTexture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, handle_.id());
}

TriangleTexture::TriangleTexture(const std::vector<std::int8_t>& bytes, std::string_view name)
    : TriangleTexture(GL_R8I, bytes.data(), bytes.size(), sizeof(std::int8_t), name) {}

TriangleTexture::TriangleTexture(const std::vector<uvec2>& words, std::string_view name)
    : TriangleTexture(GL_RG32UI, words.data(), words.size(), sizeof(uvec2), name) {}

TriangleTexture::TriangleTexture(GLenum format, const void* data, std::size_t count, std::size_t bytesEach, std::string_view name)
    : buffer_(BufferHandle::create()), handle_(TextureHandle::create()) {
    const auto limit = static_cast<std::size_t>(limitOf(GL_MAX_TEXTURE_BUFFER_SIZE));
    if (count > limit)
        throw Error(ExitStatus::overLimit, std::string(name) + ": the scene has " + std::to_string(count) +
                                               " triangles, this OpenGL driver indexes " + std::to_string(limit) +
                                               "; use a simpler mesh");
    glBindBuffer(GL_TEXTURE_BUFFER, buffer_.id());
    const uvec2 none(0); // an empty buffer is not a complete texture
    const std::size_t bytes = std::max<std::size_t>(1, count) * bytesEach;
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(bytes), count == 0 ? &none : data, GL_STATIC_DRAW);
    buffer_.holds(static_cast<std::int64_t>(bytes));
    glBindTexture(GL_TEXTURE_BUFFER, handle_.id());
    glTexBuffer(GL_TEXTURE_BUFFER, format, buffer_.id());
    label(GL_TEXTURE, handle_.id(), name);
}

void TriangleTexture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_BUFFER, handle_.id());
}

} // namespace shadowlab::gl
