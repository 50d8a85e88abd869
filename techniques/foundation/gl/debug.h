// KHR_debug where the context offers it (it is not core in 3.3): groups, labels, and errors that do not pass unseen.
// SPDX-License-Identifier: MIT
#pragma once
#include <glad/gl.h>

#include <string>
#include <string_view>

namespace shadowlab::gl {

/// Throws std::logic_error naming `where` if GL has recorded an error: that is our bug, never the user's.
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

/// What the driver complained about since the last call; empties the record.
std::string takeDebugMessages();

} // namespace shadowlab::gl
