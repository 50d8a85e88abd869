// Ownership of a GL object: created in the constructor, deleted in the destructor, movable, never copied.
// A moved-from or default handle has id 0 and owns nothing.
// SPDX-License-Identifier: MIT
#pragma once
#include <glad/gl.h>

#include <cstdint>
#include <utility>

namespace shadowlab::gl {

/// Number of GL objects alive, over all kinds. Tests hold it against the number before.
inline int liveObjects = 0;
/// Bytes of texels and buffer contents that they hold, without the overhead of the driver.
inline std::int64_t liveBytes = 0;

/// `Traits` has `static GLuint create()` and `static void destroy(GLuint)`. (glad's entry points are variables and so
/// cannot be template arguments themselves.)
template <typename Traits>
class Handle {
public:
    Handle() = default;
    static Handle create() {
        Handle handle;
        handle.id_ = Traits::create();
        ++liveObjects;
        return handle;
    }
    ~Handle() {
        if (id_ == 0) return;
        Traits::destroy(id_);
        --liveObjects;
        liveBytes -= bytes_;
    }
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)), bytes_(std::exchange(other.bytes_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(bytes_, other.bytes_);
        return *this;
    }
    /// Sets how many bytes the object holds, for liveBytes.
    void holds(std::int64_t bytes) {
        liveBytes += bytes - bytes_;
        bytes_ = bytes;
    }
    [[nodiscard]] GLuint id() const { return id_; }
    explicit operator bool() const { return id_ != 0; }

private:
    GLuint id_ = 0;
    std::int64_t bytes_ = 0;
};

struct BufferTraits {
    static GLuint create() {
        GLuint id = 0;
        glGenBuffers(1, &id);
        return id;
    }
    static void destroy(GLuint id) { glDeleteBuffers(1, &id); }
};
struct VertexArrayTraits {
    static GLuint create() {
        GLuint id = 0;
        glGenVertexArrays(1, &id);
        return id;
    }
    static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
};
struct TextureTraits {
    static GLuint create() {
        GLuint id = 0;
        glGenTextures(1, &id);
        return id;
    }
    static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};
struct FramebufferTraits {
    static GLuint create() {
        GLuint id = 0;
        glGenFramebuffers(1, &id);
        return id;
    }
    static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
};
struct ProgramTraits {
    static GLuint create() { return glCreateProgram(); }
    /// OpenGL keeps a program that is deleted while it is in use until another one is used. NVIDIA's driver 580.159 then
    /// sometimes draws the first objects of a program that is linked later without its uniforms: in a fifth of the pictures a
    /// light or a floor was missing. So a program is never in use when it is deleted.
    static void destroy(GLuint id) {
        GLint inUse = 0;
        glGetIntegerv(GL_CURRENT_PROGRAM, &inUse);
        if (static_cast<GLuint>(inUse) == id) glUseProgram(0);
        glDeleteProgram(id);
    }
};
struct QueryTraits {
    static GLuint create() {
        GLuint id = 0;
        glGenQueries(1, &id);
        return id;
    }
    static void destroy(GLuint id) { glDeleteQueries(1, &id); }
};

using BufferHandle = Handle<BufferTraits>;
using VertexArrayHandle = Handle<VertexArrayTraits>;
using TextureHandle = Handle<TextureTraits>;
using FramebufferHandle = Handle<FramebufferTraits>;
using ProgramHandle = Handle<ProgramTraits>;
using QueryHandle = Handle<QueryTraits>;

} // namespace shadowlab::gl
