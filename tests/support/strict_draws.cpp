// SPDX-License-Identifier: MIT
#include "tests/support/strict_draws.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tests/support/kept_programs.h"

namespace shadowlab::testing {

namespace {

enum class Texels { numbers, signedWhole, unsignedWhole, compared };

/// What a sampler type of GLSL 3.30 reads, as far as this project has such samplers.
struct SamplerType {
    GLenum type, target, binding;
    Texels texels;
};
constexpr SamplerType kSamplerTypes[] = {
    {GL_SAMPLER_2D, GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D, Texels::numbers},
    {GL_SAMPLER_2D_ARRAY, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY, Texels::numbers},
    {GL_SAMPLER_2D_ARRAY_SHADOW, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY, Texels::compared},
    {GL_UNSIGNED_INT_SAMPLER_2D_ARRAY, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY, Texels::unsignedWhole},
    {GL_UNSIGNED_INT_SAMPLER_2D, GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D, Texels::unsignedWhole},
    {GL_INT_SAMPLER_BUFFER, GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER, Texels::signedWhole},
};

struct Variable {
    std::string name;
    GLint location = -1;
    GLenum type = 0;
};
struct KnownProgram {
    bool asked = false;
    std::vector<Variable> samplers, attributes;
    std::string vertexText;
};

std::map<GLuint, std::pair<GLenum, std::string>> shaderTexts;
std::map<GLuint, std::vector<GLuint>> attached;
std::map<GLuint, KnownProgram> programs;
std::set<std::string> faults;

PFNGLSHADERSOURCEPROC shaderSourceOfDriver;
PFNGLATTACHSHADERPROC attachShaderOfDriver;
PFNGLLINKPROGRAMPROC linkProgramOfDriver;
PFNGLDELETEPROGRAMPROC deleteProgramOfDriver;
PFNGLDRAWARRAYSPROC drawArraysOfDriver;
PFNGLDRAWELEMENTSPROC drawElementsOfDriver;
PFNGLDRAWARRAYSINSTANCEDPROC drawArraysInstancedOfDriver;
PFNGLDRAWELEMENTSBASEVERTEXPROC drawElementsBaseVertexOfDriver;
PFNGLMULTIDRAWELEMENTSPROC multiDrawElementsOfDriver;

GLint integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

std::string numbered(const std::string& what, GLint number) { return what + " " + std::to_string(number); }

bool isSampler(GLenum type) {
    return std::ranges::any_of(kSamplerTypes, [&](const SamplerType& known) { return known.type == type; });
}

std::vector<Variable> activeVariables(GLuint program, bool uniforms) {
    GLint count = 0;
    glGetProgramiv(program, uniforms ? GL_ACTIVE_UNIFORMS : GL_ACTIVE_ATTRIBUTES, &count);
    std::vector<Variable> found;
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        char name[256] = {};
        GLint size = 0;
        Variable variable;
        (uniforms ? glGetActiveUniform : glGetActiveAttrib)(program, i, sizeof name, nullptr, &size, &variable.type,
                                                            name);
        variable.name = name;
        variable.location = uniforms ? glGetUniformLocation(program, name) : glGetAttribLocation(program, name);
        if (variable.location >= 0 && (!uniforms || isSampler(variable.type))) found.push_back(variable);
    }
    return found;
}

KnownProgram& known(GLuint program) {
    KnownProgram& entry = programs[program];
    if (!std::exchange(entry.asked, true)) {
        entry.samplers = activeVariables(program, true);
        entry.attributes = activeVariables(program, false);
    }
    return entry;
}

/// Of the texture that is bound to the target on the active unit.
struct BoundTexture {
    Texels texels = Texels::numbers;
    bool complete = true;
};

BoundTexture boundTexture(GLenum target) {
    BoundTexture bound;
    const auto levelValue = [&](GLint level, GLenum name) {
        GLint value = 0;
        glGetTexLevelParameteriv(target, level, name, &value);
        return value;
    };
    const auto parameter = [&](GLenum name) {
        GLint value = 0;
        glGetTexParameteriv(target, name, &value);
        return value;
    };
    const GLint red = levelValue(0, GL_TEXTURE_RED_TYPE), depth = levelValue(0, GL_TEXTURE_DEPTH_TYPE);
    if (red == GL_INT) bound.texels = Texels::signedWhole;
    if (red == GL_UNSIGNED_INT) bound.texels = Texels::unsignedWhole;
    if (target == GL_TEXTURE_BUFFER) return bound;
    if (depth != GL_NONE && parameter(GL_TEXTURE_COMPARE_MODE) != GL_NONE) bound.texels = Texels::compared;
    const GLint smaller = parameter(GL_TEXTURE_MIN_FILTER);
    const GLint width = levelValue(0, GL_TEXTURE_WIDTH), height = levelValue(0, GL_TEXTURE_HEIGHT);
    if (width == 0 || height == 0) bound.complete = false;
    const bool wholeNumbers = bound.texels == Texels::signedWhole || bound.texels == Texels::unsignedWhole;
    if (wholeNumbers && (smaller != GL_NEAREST || parameter(GL_TEXTURE_MAG_FILTER) != GL_NEAREST))
        bound.complete = false;
    if (smaller == GL_NEAREST || smaller == GL_LINEAR) return bound;
    const int last = std::min(static_cast<int>(std::log2(std::max(width, height))), parameter(GL_TEXTURE_MAX_LEVEL));
    for (GLint level = 0; level <= last; ++level)
        if (levelValue(level, GL_TEXTURE_WIDTH) != std::max(width >> level, 1)) bound.complete = false;
    return bound;
}

std::set<GLuint> texturesOfTarget() {
    std::set<GLuint> textures;
    for (const GLenum attachment : {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT}) {
        GLint type = 0, name = 0;
        const auto ask = glGetFramebufferAttachmentParameteriv;
        ask(GL_DRAW_FRAMEBUFFER, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
        if (type != GL_TEXTURE) continue;
        ask(GL_DRAW_FRAMEBUFFER, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &name);
        textures.insert(static_cast<GLuint>(name));
    }
    return textures;
}

void lookAtSamplers(GLuint program, const std::vector<Variable>& samplers, const std::string& where) {
    const std::set<GLuint> written =
        integer(GL_DRAW_FRAMEBUFFER_BINDING) == 0 ? std::set<GLuint>{} : texturesOfTarget();
    const GLint activeBefore = integer(GL_ACTIVE_TEXTURE);
    for (const Variable& sampler : samplers) {
        const SamplerType& wanted = *std::ranges::find(kSamplerTypes, sampler.type, &SamplerType::type);
        GLint unit = 0;
        glGetUniformiv(program, sampler.location, &unit);
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        const auto texture = static_cast<GLuint>(integer(wanted.binding));
        const std::string what = where + ": sampler " + sampler.name + ", " + numbered("unit", unit);
        if (texture == 0) {
            faults.insert(what + " has no texture");
            continue;
        }
        const BoundTexture bound = boundTexture(wanted.target);
        if (!bound.complete) faults.insert(what + ": the texture is incomplete");
        if (bound.texels != wanted.texels) faults.insert(what + ": the texels are not what the sampler reads");
        if (written.contains(texture)) faults.insert(what + ": the texture is a part of the target");
    }
    glActiveTexture(static_cast<GLenum>(activeBefore));
}

void lookAtAttributes(const std::vector<Variable>& attributes, const std::string& where) {
    for (const Variable& attribute : attributes) {
        GLint enabled = 0, fromWhole = 0;
        const auto index = static_cast<GLuint>(attribute.location);
        glGetVertexAttribiv(index, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &enabled);
        glGetVertexAttribiv(index, GL_VERTEX_ATTRIB_ARRAY_INTEGER, &fromWhole);
        const bool wantsWhole = attribute.type == GL_INT || attribute.type == GL_UNSIGNED_INT;
        // Without an array it is one value for all vertices. Mesa 26 counts attributes that nothing in the program depends on.
        if (enabled && wantsWhole != (fromWhole != 0))
            faults.insert(where + ": attribute " + attribute.name + " and its array differ in being whole numbers");
    }
}

void lookAtClipDistances(const std::string& vertexText, const std::string& where) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_CLIP_DISTANCES, &most);
    for (GLint i = 0; i < most; ++i)
        if (glIsEnabled(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i)) &&
            vertexText.find("gl_ClipDistance[" + std::to_string(i) + "] =") == std::string::npos)
            faults.insert(where + ": " + numbered("clip distance", i) + " is enabled and not written");
}

/// Of its files, where the driver keeps labels.
std::string nameOf(GLuint program) {
    char label[256] = {};
    if (GLAD_GL_KHR_debug) glGetObjectLabel(GL_PROGRAM, program, sizeof label, nullptr, label);
    return *label ? label : numbered("program", static_cast<GLint>(program));
}

void lookAtDraw() {
    const auto program = static_cast<GLuint>(integer(GL_CURRENT_PROGRAM));
    if (program == 0) {
        faults.insert("a draw call without a program");
        return;
    }
    const KnownProgram& drawn = known(program);
    const std::string where = nameOf(program);
    if (integer(GL_VERTEX_ARRAY_BINDING) == 0) faults.insert(where + ": no vertex array");
    if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        faults.insert(where + ": the target is incomplete");
    lookAtSamplers(program, drawn.samplers, where);
    lookAtAttributes(drawn.attributes, where);
    if (!drawn.vertexText.empty()) lookAtClipDistances(drawn.vertexText, where);
    glValidateProgram(program);
    GLint valid = 0;
    glGetProgramiv(program, GL_VALIDATE_STATUS, &valid);
    if (valid) return;
    char log[512] = {};
    glGetProgramInfoLog(program, sizeof log, nullptr, log);
    faults.insert(where + ": not valid, " + log);
}

void GLAD_API_PTR shaderSource(GLuint shader, GLsizei count, const GLchar* const* texts, const GLint* lengths) {
    GLint type = 0;
    glGetShaderiv(shader, GL_SHADER_TYPE, &type);
    shaderTexts[shader] = {static_cast<GLenum>(type), count == 1 && !lengths ? texts[0] : ""};
    shaderSourceOfDriver(shader, count, texts, lengths);
}

void GLAD_API_PTR attachShader(GLuint program, GLuint shader) {
    attached[program].push_back(shader);
    attachShaderOfDriver(program, shader);
}

void GLAD_API_PTR linkProgram(GLuint program) {
    linkProgramOfDriver(program);
    std::map<GLenum, std::string> texts;
    for (const GLuint shader : attached[program])
        texts[shaderTexts[shader].first] = shaderTexts[shader].second;
    attached.erase(program); // a program of the same number may follow
    programs[program] = {};
    programs[program].vertexText = texts[GL_VERTEX_SHADER];
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked) keepProgram(texts[GL_VERTEX_SHADER], texts[GL_FRAGMENT_SHADER]);
}

void GLAD_API_PTR deleteProgram(GLuint program) {
    if (program != 0 && static_cast<GLuint>(integer(GL_CURRENT_PROGRAM)) == program)
        faults.insert(nameOf(program) + ": deleted while it is in use (ProgramTraits in techniques/foundation/gl/handle.h)");
    deleteProgramOfDriver(program);
}

void GLAD_API_PTR drawArrays(GLenum mode, GLint first, GLsizei count) {
    lookAtDraw();
    drawArraysOfDriver(mode, first, count);
}

void GLAD_API_PTR drawElements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
    lookAtDraw();
    drawElementsOfDriver(mode, count, type, indices);
}

void GLAD_API_PTR drawArraysInstanced(GLenum mode, GLint first, GLsizei count, GLsizei instances) {
    lookAtDraw();
    drawArraysInstancedOfDriver(mode, first, count, instances);
}

void GLAD_API_PTR drawElementsBaseVertex(GLenum mode, GLsizei count, GLenum type, const void* indices, GLint base) {
    lookAtDraw();
    drawElementsBaseVertexOfDriver(mode, count, type, indices, base);
}

void GLAD_API_PTR multiDrawElements(GLenum mode, const GLsizei* counts, GLenum type, const void* const* indices,
                                    GLsizei draws) {
    lookAtDraw();
    multiDrawElementsOfDriver(mode, counts, type, indices, draws);
}

/// Puts `ours` in the place of what the driver has for it, unless it is there already.
template <typename Function>
void takePlace(Function& entry, Function& ofDriver, Function ours) {
    if (entry == ours) return;
    ofDriver = entry;
    entry = ours;
}

} // namespace

void watchDraws() {
    if (glad_glDrawArrays != drawArrays) { // the context was made current: numbers may stand for other objects now
        shaderTexts.clear();
        attached.clear();
    }
    takePlace(glad_glShaderSource, shaderSourceOfDriver, PFNGLSHADERSOURCEPROC{shaderSource});
    takePlace(glad_glAttachShader, attachShaderOfDriver, PFNGLATTACHSHADERPROC{attachShader});
    takePlace(glad_glLinkProgram, linkProgramOfDriver, PFNGLLINKPROGRAMPROC{linkProgram});
    takePlace(glad_glDeleteProgram, deleteProgramOfDriver, PFNGLDELETEPROGRAMPROC{deleteProgram});
    takePlace(glad_glDrawArrays, drawArraysOfDriver, PFNGLDRAWARRAYSPROC{drawArrays});
    takePlace(glad_glDrawElements, drawElementsOfDriver, PFNGLDRAWELEMENTSPROC{drawElements});
    takePlace(glad_glDrawArraysInstanced, drawArraysInstancedOfDriver,
              PFNGLDRAWARRAYSINSTANCEDPROC{drawArraysInstanced});
    takePlace(glad_glDrawElementsBaseVertex, drawElementsBaseVertexOfDriver,
              PFNGLDRAWELEMENTSBASEVERTEXPROC{drawElementsBaseVertex});
    takePlace(glad_glMultiDrawElements, multiDrawElementsOfDriver, PFNGLMULTIDRAWELEMENTSPROC{multiDrawElements});
}

std::string takeDrawFaults() {
    std::string all;
    for (const std::string& fault : faults)
        all += fault + "\n";
    faults.clear();
    return all;
}

} // namespace shadowlab::testing
