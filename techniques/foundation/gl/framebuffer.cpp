// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/framebuffer.h"

#include <array>
#include <stdexcept>
#include <string>

#include "techniques/foundation/base/software.h"
#include "techniques/foundation/gl/debug.h"

namespace shadowlab::gl {

namespace {

/// llvmpipe frees the fence of what has been drawn into a framebuffer as soon as its last thread has counted itself in, and that thread then
/// still wakes who waits, and unlocks: in freed memory, if the scheduler stops it just there (docs/systems.md). A sync object keeps the fence
/// until a few more framebuffers have been drawn into.
void keepFence() {
    constexpr std::size_t kKept = 8; // framebuffers; llvmpipe is rarely two behind
    static thread_local std::array<GLsync, kKept> kept{};
    static thread_local std::size_t next = 0;
    GLsync& oldest = kept[next++ % kKept];
    if (glIsSync(oldest)) glDeleteSync(oldest); // else of a context that is gone
    oldest = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

void bindToDraw(GLuint framebuffer) {
    GLint bound = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    if (static_cast<GLuint>(bound) != framebuffer && isSoftware(reinterpret_cast<const char*>(glGetString(GL_RENDERER)))) keepFence();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

} // namespace

Framebuffer::Framebuffer(const Texture2D* color, const Texture2D* depthStencil, std::string_view name)
    : handle_(FramebufferHandle::create()), size_(color ? color->size() : depthStencil->size()) {
    bindToDraw(handle_.id());
    if (color) {
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color->id(), 0);
    } else {
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
    }
    if (depthStencil)
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, depthStencil->id(), 0);
    requireComplete(name);
}

Framebuffer::Framebuffer(const Texture2D& first, const Texture2D& second, const Texture2D& depthStencil,
                         std::string_view name)
    : handle_(FramebufferHandle::create()), size_(first.size()) {
    bindToDraw(handle_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, first.id(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, second.id(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, depthStencil.id(), 0);
    constexpr std::array<GLenum, 2> kOutputs{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(static_cast<GLsizei>(kOutputs.size()), kOutputs.data());
    requireComplete(name);
}

Framebuffer::Framebuffer(const DepthTextureArray& depth, int layer, std::string_view name)
    : handle_(FramebufferHandle::create()), size_(depth.side()) {
    bindToDraw(handle_.id());
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depth.id(), 0, layer);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    requireComplete(name);
}

Framebuffer::Framebuffer(const IdTextureArray& ids, const DepthTextureArray& depth, int layer, std::string_view name)
    : handle_(FramebufferHandle::create()), size_(ids.side()) {
    bindToDraw(handle_.id());
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, ids.id(), 0, layer);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depth.id(), 0, layer);
    requireComplete(name);
}

Framebuffer::Framebuffer(const ColorTextureArray& color, int layer, std::string_view name)
    : handle_(FramebufferHandle::create()), size_(color.side()) {
    bindToDraw(handle_.id());
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, color.id(), 0, layer);
    requireComplete(name);
}

void Framebuffer::bind() const {
    bindToDraw(handle_.id());
    glViewport(0, 0, size_.x, size_.y);
}

void Framebuffer::requireComplete(std::string_view name) const {
    label(GL_FRAMEBUFFER, handle_.id(), name);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE) return;
    const char* why = "unknown reason";
    switch (status) {
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT: why = "an attachment is unusable (no size, or a wrong format)"; break;
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT: why = "it has no attachment"; break;
    case GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER: why = "a draw buffer has no attachment"; break;
    case GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER: why = "the read buffer has no attachment"; break;
    case GL_FRAMEBUFFER_UNSUPPORTED: why = "the driver does not support this combination of formats"; break;
    case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE: why = "the attachments differ in their number of samples"; break;
    default: break;
    }
    throw std::logic_error("framebuffer '" + std::string(name) + "' is incomplete: " + why);
}

} // namespace shadowlab::gl
