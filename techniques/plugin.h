// A plug-in: techniques in a shared library, built outside of the project, taken in beside ours by `--plugin FILE`.
//
// A plug-in is written like any technique (technique.h). What leads the program to it is generated when it is built, by
// shadowlab_plugin() of the installed CMake package: two symbols with C linkage. The first is a text, and says which contract
// the plug-in was built for. The program looks for it in the file and refuses another one before anything of the plug-in runs:
// what lies where in memory is not the same any more. The second is a function that returns the Plugin.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "techniques/foundation/gl/shader_source.h"
#include "techniques/source_text.h"
#include "techniques/technique.h"

namespace shadowlab {

struct Plugin {
    std::string_view folder; ///< of the plug-in: the name of its namespace, and of its folder of shaders
    std::span<const TechniqueInfo> (*techniques)() = nullptr;
    std::span<const gl::EmbeddedShader> shaders; ///< names begin with `folder` and a slash
    std::span<const EmbeddedSource> sources;     ///< those with an anchor
    std::string_view shaderFolder;               ///< where the shaders were when it was built
    std::string_view family;                     ///< what `grade` asks of it (app/student/grading/families.h); empty: not said
};

/// What the text in a plug-in begins with; 16 hexadecimal digits and a line feed follow.
inline constexpr std::string_view kContractMark = "shadowlab plug-in contract ";

/// Name of the function `const Plugin* ()`.
inline constexpr const char* kPluginEntry = "shadowlabPlugin";

/// The digits of this program: they stand for all headers that a plug-in may include, and the shaders that its own may.
std::string_view contractOfProgram();

} // namespace shadowlab
