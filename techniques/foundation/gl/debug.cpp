// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/debug.h"

#include <stdexcept>
#include <utility>

namespace shadowlab::gl {

namespace {

std::string collected;

const char* errorName(GLenum error) {
    switch (error) {
    case GL_INVALID_ENUM: return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE: return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION: return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION: return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY: return "GL_OUT_OF_MEMORY";
    default: return "unknown GL error";
    }
}

void GLAD_API_PTR onMessage(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text,
                            const void*) {
    // Whatever their severity, because what one driver calls deprecated another one refuses.
    const bool serious = type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
                         type == GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR || severity == GL_DEBUG_SEVERITY_HIGH;
    if (serious) collected += std::string(text, static_cast<std::size_t>(length)) + "\n";
}

} // namespace

void check(std::string_view where) {
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw std::logic_error(std::string(errorName(error)) + " in " + std::string(where));
}

void label(GLenum identifier, GLuint id, std::string_view name) {
    if (GLAD_GL_KHR_debug) glObjectLabel(identifier, id, static_cast<GLsizei>(name.size()), name.data());
}

DebugGroup::DebugGroup(std::string_view name) {
    if (GLAD_GL_KHR_debug)
        glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, static_cast<GLsizei>(name.size()), name.data());
}

DebugGroup::~DebugGroup() {
    if (GLAD_GL_KHR_debug) glPopDebugGroup();
}

void collectDebugMessages() {
    if (!GLAD_GL_KHR_debug) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(onMessage, nullptr);
}

std::string takeDebugMessages() { return std::exchange(collected, {}); }

} // namespace shadowlab::gl
