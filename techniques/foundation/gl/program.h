// A linked shader program whose uniforms are set by the name they have in GLSL.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "techniques/foundation/gl/handle.h"
#include "techniques/foundation/gl/shader_source.h"
#include "techniques/foundation/math/types.h"

namespace shadowlab::gl {

class Program {
public:
    Program() = default;
    /// Names two files of the shaders folder. Nothing is compiled before first use: making a program needs no context,
    /// and one that is never used costs nothing.
    Program(std::string vertexFile, std::string fragmentFile, std::vector<std::string> defines = {},
            std::vector<Substitution> substitutions = {});
    /// Compiles and links when necessary. Throws Error (badInput) with `FILE:LINE: message`.
    void use() const;
    /// The same, made with these defines as well, from now on and until others are asked for: for what is the same all over a
    /// draw call (the kind of a light) and so need not be asked for each pixel. Each set of defines has uniforms of its own, so
    /// set them afterwards.
    void useWith(const std::vector<std::string>& moreDefines) const;

    /// The same program, made with CUT_HOLES: for surfaces with holes, in passes that write depth (shaders/cut_holes.glsl).
    [[nodiscard]] const Program& alphaTested() const;

    /// Does the program in use read this uniform? Those that the linker removed it does not.
    [[nodiscard]] bool reads(std::string_view name) const { return location(name) >= 0; }
    [[nodiscard]] bool isMadeWith(std::string_view define) const;

    /// Set a uniform of the program in use. A name the linker removed as unused is ignored.
    void set(std::string_view name, int value) const;
    void set(std::string_view name, float value) const;
    void set(std::string_view name, const vec2& value) const;
    void set(std::string_view name, const vec3& value) const;
    void set(std::string_view name, const vec4& value) const;
    void set(std::string_view name, const mat3& value) const;
    void set(std::string_view name, const mat4& value) const;
    void set(std::string_view name, std::span<const mat4> values) const;
    void set(std::string_view name, std::span<const vec4> values) const;

private:
    struct NameHash {
        using is_transparent = void;
        std::size_t operator()(std::string_view name) const { return std::hash<std::string_view>{}(name); }
    };
    /// Where a uniform is, and which one was set after it the last time: objects set the same ones in the same order, so that
    /// next time it is most likely the one that is asked for, and no name has to be looked up.
    struct Uniform {
        GLint location = -1;
        std::pair<const std::string, Uniform>* next = nullptr;
    };
    /// What was compiled, with one set of further defines.
    struct Linked {
        ProgramHandle handle;
        int reloadsSeen = 0;
        std::unordered_map<std::string, Uniform, NameHash, std::equal_to<>> uniforms;
        Uniform* last = nullptr; ///< that was set
    };
    void link(Linked& linked, const std::vector<std::string>& moreDefines) const;
    void relink(Linked& linked, const std::vector<std::string>& moreDefines) const;
    [[nodiscard]] GLint location(std::string_view name) const;
    std::string vertexFile_, fragmentFile_;
    std::vector<std::string> defines_;
    std::vector<Substitution> substitutions_;
    mutable std::unique_ptr<const Program> alphaTested_; ///< made when first asked for
    mutable std::map<std::vector<std::string>, Linked> linked_;
    mutable std::vector<std::string> chosen_; ///< the key of what use() puts to use
    mutable Linked* inUse_ = nullptr;
};

/// From now on every program compiles its files anew before it is used again. One that no longer compiles stays as it was,
/// and the fault is kept for takeShaderFaults(): a picture that is on show does not vanish over a slip of the pen.
void reloadShaders();
/// How often reloadShaders() was called: what was drawn before the last time is out of date.
int shaderReloads();
/// The faults since the last call, each `FILE:LINE: message; mend the shader`.
std::vector<std::string> takeShaderFaults();

/// Draws one triangle that covers the target, for programs made with "fullscreen.vert".
void drawFullscreenTriangle();

} // namespace shadowlab::gl
