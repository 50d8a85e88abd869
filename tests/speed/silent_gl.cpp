// SPDX-License-Identifier: MIT
#include "tests/speed/silent_gl.h"

#include <glad/gl.h>

#include <map>
#include <string>

namespace shadowlab::speed {

namespace {

using Function = void (*)();

/// Every call that has to be answered, as the driver answers it.
std::map<std::string, Function>& answering() {
    static std::map<std::string, Function> functions;
    return functions;
}

template <typename Entry>
void keep(const char* name, Entry entry) {
    answering()[name] = reinterpret_cast<Function>(entry);
}

/// Stands for functions with any parameters and no result: on the machines that the project runs on the caller takes its
/// arguments off the stack itself.
void nothing() {}
GLenum noError() { return GL_NO_ERROR; }

Function entryFor(const char* name) {
    const auto found = answering().find(name);
    return found != answering().end() ? found->second : nothing;
}

} // namespace

void silenceGl() {
    keep("glGetString", glGetString);
    keep("glGetStringi", glGetStringi);
    keep("glGetIntegerv", glGetIntegerv);
    keep("glGetUniformLocation", glGetUniformLocation);
    keep("glGetShaderiv", glGetShaderiv);
    keep("glGetProgramiv", glGetProgramiv);
    keep("glCheckFramebufferStatus", glCheckFramebufferStatus);
    keep("glGenBuffers", glGenBuffers);
    keep("glGenFramebuffers", glGenFramebuffers);
    keep("glGenQueries", glGenQueries);
    keep("glGenTextures", glGenTextures);
    keep("glGenVertexArrays", glGenVertexArrays);
    keep("glCreateProgram", glCreateProgram);
    keep("glCreateShader", glCreateShader);
    keep("glGetError", noError);
    gladLoadGL(entryFor);
}

} // namespace shadowlab::speed
