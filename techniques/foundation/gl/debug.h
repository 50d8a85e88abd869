// KHR_debug where the context offers it (it is not core in 3.3): groups, labels, and error messages.
// SPDX-License-Identifier: MIT
#pragma once
#include <glad/gl.h>

#include <string>
#include <string_view>

namespace shadowlab::gl {

/// Throws std::logic_error naming `where` if GL has recorded an error: a bug of the program, not a fault of the user.
void check(std::string_view where);

/// Names an object for debuggers. `identifier` is GL_TEXTURE, GL_FRAMEBUFFER, GL_PROGRAM, GL_BUFFER ...
/// The object must have been bound once. No effect without KHR_debug.
void label(GLenum identifier, GLuint id, std::string_view name);

/// A named group of commands in debuggers and traces, open as long as it lives.
class DebugGroup {
public:
    explicit DebugGroup(std::string_view name);
    ~DebugGroup();
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;
};

/// Keeps driver messages of type ERROR, UNDEFINED_BEHAVIOR and DEPRECATED_BEHAVIOR, or of severity HIGH, for takeDebugMessages().
void collectDebugMessages();

/// The driver messages since the last call; empties the record.
std::string takeDebugMessages();

} // namespace shadowlab::gl
