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
    /// Uses a variant compiled with these further defines, until another one is asked for. For values that are constant in
    /// a draw call (the kind of a light), which the shader then need not test per pixel. Each variant has its own uniforms,
    /// so set them afterwards.
    void useWith(const std::vector<std::string>& moreDefines) const;

    /// The alpha-tested variant, compiled with CUT_HOLES: for surfaces with holes, in passes that write depth
    /// (shaders/cut_holes.glsl).
    [[nodiscard]] const Program& alphaTested() const;

    /// True if the program in use reads this uniform; false for one that the linker removed.
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
    /// A cache against lookups by name. Draw calls set the same uniforms in the same order, so each entry remembers which
    /// uniform was set after it the last time; it is most likely the next one again.
    struct Uniform {
        GLint location = -1;
        std::pair<const std::string, Uniform>* next = nullptr;
    };
    /// One linked variant: the program for one set of further defines.
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
/// and the error is kept for takeShaderFaults(), so that a typing error does not remove the picture from the screen.
void reloadShaders();
/// How often reloadShaders() was called: part of every cache key for pictures.
int shaderReloads();
/// The errors since the last call, each one line that begins with FILE:LINE.
std::vector<std::string> takeShaderFaults();

/// Draws one triangle that covers the target, for programs made with "fullscreen.vert".
void drawFullscreenTriangle();

} // namespace shadowlab::gl
