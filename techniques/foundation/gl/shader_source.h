// Shader text: embedded at build time, #include resolved here, so that a compile error names the true file and line.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shadowlab::gl {

/// One file of the shaders folder; the name is relative to it ("shadow_map/filters/filter_pcf.glsl").
struct EmbeddedShader {
    std::string_view name;
    std::string_view text;
};

/// Every shader, from the generated file.
std::span<const EmbeddedShader> embeddedShaders();

/// A shader after its includes: the text for the compiler and the files it came from.
///
/// File n counts its lines from n * kLinesPerFile. GLSL has source string numbers for that, but Mesa's compiler forgets
/// them in its messages; line numbers are reported by every compiler.
struct ShaderSource {
    static constexpr unsigned long kLinesPerFile = 100'000;
    std::string text;
    std::vector<std::string> files;
};

/// Text of `name` with `#include "other.glsl"` resolved (each file once), `defines` ("NAME value") placed after the
/// #version line, and `substitutions` (include name -> the file to use instead) applied: that is how one file is chosen
/// among several filters without a ladder of #ifs. When the environment variable SHADOWLAB_SHADERS names a folder,
/// files found there replace the embedded ones. Throws Error (badInput): `FILE:LINE: includes "x", which does not
/// exist; ...`.
struct Substitution {
    std::string includeName, file;
};
ShaderSource shaderSource(std::string_view name, std::span<const std::string> defines = {},
                          std::span<const Substitution> substitutions = {});

/// A compiler's log with `0:12(5): error` (Mesa), `0(12) : error` (NVIDIA) and `ERROR: 0:12:` (others) rewritten to
/// `FILE:12: ...`.
std::string withFileNames(std::string_view log, const ShaderSource& source);

/// Adds the shaders of a plug-in, whose texts must outlive the program. They were read from `folder`.
void addShaders(std::span<const EmbeddedShader> shaders, std::string folder);

/// Every shader: the program's own, and after them those that were added.
std::vector<EmbeddedShader> allShaders();

/// The folders that added shaders were read from.
const std::vector<std::string>& addedShaderFolders();

/// From now on added shaders are read from their folders if they are still there, so that edits take effect.
void readAddedShadersFromFolders();

/// One file as programs are compiled from it now: from the folder that the environment variable SHADOWLAB_SHADERS names,
/// where it is there, else as it was embedded. Nothing where there is no such file.
std::optional<std::string> shaderText(std::string_view name);

} // namespace shadowlab::gl
