// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/program.h"

#include <algorithm>
#include <utility>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/gl/debug.h"

namespace shadowlab::gl {

namespace {

/// A shader object that is deleted once the program has it.
struct Shader {
    GLuint id;
    explicit Shader(GLenum type) : id(glCreateShader(type)) {}
    ~Shader() { glDeleteShader(id); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
};

template <typename GetLength, typename GetLog>
std::string infoLog(GLuint id, GetLength getLength, GetLog getLog) {
    GLint length = 0;
    getLength(id, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    GLsizei written = 0;
    getLog(id, length, &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return log;
}

/// The first line of the log that reports an error, because messages are one line long.
std::string firstError(const std::string& log) {
    const std::size_t at = log.find("error");
    const std::size_t begin = at == std::string::npos ? 0 : log.rfind('\n', at) + 1;
    return log.substr(begin, log.find('\n', begin) - begin);
}

int reloads = 0; ///< how often reloadShaders() was called; needs no lock, because GL is used from one thread
std::vector<std::string>& faults() {
    static std::vector<std::string> kept;
    return kept;
}

void compile(const Shader& shader, const ShaderSource& source) {
    const char* text = source.text.c_str();
    glShaderSource(shader.id, 1, &text, nullptr);
    glCompileShader(shader.id);
    GLint compiled = 0;
    glGetShaderiv(shader.id, GL_COMPILE_STATUS, &compiled);
    if (compiled) return;
    const std::string log = withFileNames(infoLog(shader.id, glGetShaderiv, glGetShaderInfoLog), source);
    throw Error(ExitStatus::badInput, firstError(log) + "; fix the shader");
}

bool isSampler(GLenum type) {
    switch (type) { // of those in shaders/
    case GL_SAMPLER_2D:
    case GL_SAMPLER_2D_ARRAY:
    case GL_SAMPLER_2D_ARRAY_SHADOW:
    case GL_UNSIGNED_INT_SAMPLER_2D_ARRAY:
    case GL_UNSIGNED_INT_SAMPLER_2D:
    case GL_INT_SAMPLER_BUFFER: return true;
    default: return false;
    }
}

/// All samplers start at texture unit 0, and drawing with two samplers of different types on one unit is an error, even if
/// the shader reads neither. Mesa removes unused samplers, but other linkers may keep them. So every sampler gets a unit of
/// its own here, from the last unit downward.
void spreadSamplers(GLuint program) {
    GLint count = 0, unit = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    glGetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &unit);
    glUseProgram(program);
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        char name[64] = {}; // samplers have short names, and stand in no array
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program, i, sizeof name, nullptr, &size, &type, name);
        if (isSampler(type)) glUniform1i(glGetUniformLocation(program, name), --unit);
    }
}

} // namespace

Program::Program(std::string vertexFile, std::string fragmentFile, std::vector<std::string> defines,
                 std::vector<Substitution> substitutions)
    : vertexFile_(std::move(vertexFile)), fragmentFile_(std::move(fragmentFile)), defines_(std::move(defines)),
      substitutions_(std::move(substitutions)) {}

void reloadShaders() { ++reloads; }

int shaderReloads() { return reloads; }

std::vector<std::string> takeShaderFaults() { return std::exchange(faults(), {}); }

void Program::use() const { useWith(chosen_); }

void Program::useWith(const std::vector<std::string>& moreDefines) const {
    Linked& linked = linked_[moreDefines];
    if (!linked.handle)
        link(linked, moreDefines);
    else if (linked.reloadsSeen != reloads)
        relink(linked, moreDefines);
    if (chosen_ != moreDefines) chosen_ = moreDefines;
    inUse_ = &linked;
    glUseProgram(linked.handle.id());
}

const Program& Program::alphaTested() const {
    if (!alphaTested_) {
        std::vector<std::string> defines = defines_;
        defines.emplace_back("CUT_HOLES");
        alphaTested_ = std::make_unique<const Program>(vertexFile_, fragmentFile_, std::move(defines), substitutions_);
    }
    return *alphaTested_;
}

void Program::relink(Linked& linked, const std::vector<std::string>& moreDefines) const {
    linked.reloadsSeen = reloads;
    try {
        link(linked, moreDefines);
        linked.uniforms.clear();
        linked.last = nullptr;
    } catch (const Error& fault) {
        faults().emplace_back(fault.what());
    }
}

void Program::link(Linked& linked, const std::vector<std::string>& moreDefines) const {
    linked.reloadsSeen = reloads;
    std::vector<std::string> defines = defines_;
    defines.insert(defines.end(), moreDefines.begin(), moreDefines.end());
    const Shader vertex(GL_VERTEX_SHADER), fragment(GL_FRAGMENT_SHADER);
    compile(fragment, shaderSource(fragmentFile_, defines, substitutions_));
    ProgramHandle handle = ProgramHandle::create();
    compile(vertex, shaderSource(vertexFile_, defines, substitutions_));
    glAttachShader(handle.id(), vertex.id);
    glAttachShader(handle.id(), fragment.id);
    glLinkProgram(handle.id());
    GLint isLinked = 0;
    glGetProgramiv(handle.id(), GL_LINK_STATUS, &isLinked);
    const std::string name = vertexFile_ + " + " + fragmentFile_;
    if (!isLinked)
        throw Error(ExitStatus::badInput, name + ": " +
                                              firstError(infoLog(handle.id(), glGetProgramiv, glGetProgramInfoLog)) +
                                              "; fix the shaders");
    label(GL_PROGRAM, handle.id(), name);
    spreadSamplers(handle.id());
    linked.handle = std::move(handle);
}

bool Program::isMadeWith(std::string_view define) const {
    return std::ranges::find(defines_, define) != defines_.end();
}

GLint Program::location(std::string_view name) const {
    Uniform* const before = inUse_->last;
    if (before && before->next && before->next->first == name) {
        inUse_->last = &before->next->second;
        return inUse_->last->location;
    }
    auto found = inUse_->uniforms.find(name);
    if (found == inUse_->uniforms.end()) {
        const std::string key(name);
        found = inUse_->uniforms.emplace(key, Uniform{glGetUniformLocation(inUse_->handle.id(), key.c_str())}).first;
    }
    if (before) before->next = &*found; // places in an unordered_map stay where they are
    inUse_->last = &found->second;
    return found->second.location;
}

void Program::set(std::string_view name, int value) const { glUniform1i(location(name), value); }
void Program::set(std::string_view name, float value) const { glUniform1f(location(name), value); }
void Program::set(std::string_view name, const vec2& value) const { glUniform2fv(location(name), 1, &value[0]); }
void Program::set(std::string_view name, const vec3& value) const { glUniform3fv(location(name), 1, &value[0]); }
void Program::set(std::string_view name, const vec4& value) const { glUniform4fv(location(name), 1, &value[0]); }
void Program::set(std::string_view name, const mat3& value) const {
    glUniformMatrix3fv(location(name), 1, GL_FALSE, &value[0][0]);
}
void Program::set(std::string_view name, const mat4& value) const {
    glUniformMatrix4fv(location(name), 1, GL_FALSE, &value[0][0]);
}
void Program::set(std::string_view name, std::span<const mat4> values) const {
    if (!values.empty())
        glUniformMatrix4fv(location(name), static_cast<GLsizei>(values.size()), GL_FALSE, &values[0][0][0]);
}
void Program::set(std::string_view name, std::span<const vec4> values) const {
    if (!values.empty()) glUniform4fv(location(name), static_cast<GLsizei>(values.size()), &values[0][0]);
}

void drawFullscreenTriangle() {
    const VertexArrayHandle empty = VertexArrayHandle::create(); // the core profile needs a bound vertex array
    glBindVertexArray(empty.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

} // namespace shadowlab::gl
