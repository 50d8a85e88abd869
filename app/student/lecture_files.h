// The files of one of the lecture's algorithms, and how they are called in the folder of a plug-in.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

#include "app/student/blanks.h"

namespace shadowlab::student {

/// techniques/lecture/SOURCE.cpp, and what it needs beside the installed headers and shaders: its words/, parts/, and shaders/lecture.
/// Throws Error (badInput) where there is no such algorithm.
SourceFiles lectureFiles(const std::string& source);

/// "techniques/lecture/parts/rays.h" -> "rays.h"; "shaders/lecture/project.vert" -> "shaders/my_shadows/project.vert".
std::string nameInPlugin(const std::string& name, const std::string& source);

/// The same, as files of a plug-in with the namespace my_shadows: "technique.cpp", "words.h", "rays.cpp",
/// "shaders/my_shadows/project.vert". It has one technique, `my-shadows`, and its anchors begin with that.
SourceFiles asPlugin(const SourceFiles& files, const std::string& source);

/// "lecture-tree" -> "tree": how its anchor ends in a plug-in, "my-shadows-tree".
std::string withoutLecture(const std::string& anchor);

/// Replaces every occurrence; what is put in is not looked at again.
void replaceAll(std::string& text, std::string_view from, std::string_view to);

} // namespace shadowlab::student
