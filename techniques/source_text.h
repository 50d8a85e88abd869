// The project's own source, as far as steps of algorithms are shown in it.
//
// What a step does is marked where it is done, by a comment of its own line before the first of its lines:
//
//     // [anchor: flatten]
//
// A snippet is what follows: up to an empty line after which nothing is indented deeper than its first line, or a line that is
// indented less. So it is a paragraph, or a function with all that is in it. Steps name their anchors (PassInfo::anchors),
// and each name stands in one place of all shaders and techniques.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/technique.h"

namespace shadowlab {

/// A C++ file with an anchor, or of techniques/lecture, as it was when the program was built; the name is relative to the project.
struct EmbeddedSource {
    std::string_view name, text;
};

/// All of them, from the generated file.
std::span<const EmbeddedSource> embeddedSources();

/// The lines that an anchor stands for.
struct Snippet {
    std::string anchor;
    std::string file; ///< relative to the project: "shaders/planar/flatten.vert"
    LineRange lines;  ///< of the file
};

/// An anchor of a step, and the parameter that must have that value for its lines to run; an empty one: they always do.
struct AnchorUse {
    std::string anchor, parameter, value;
};

/// "map-place compare-pcf[filter=pcf]": two uses. Throws Error (bug) for what is not written like that.
std::vector<AnchorUse> anchorsOf(const PassInfo& pass);

class SourceText {
public:
    /// Shaders as programs are compiled from them now (gl/shader_text.h), C++ as it was built.
    static SourceText read();

    /// Adds a file. Takes in its anchors, also those that stand elsewhere already.
    void add(std::string file, std::string_view text);

    /// Throws Error (badInput) naming the nearest anchors where there is none of that name, and both places where there are two.
    [[nodiscard]] const Snippet& at(std::string_view anchor) const;
    /// In the order in which they were added.
    [[nodiscard]] const std::vector<Snippet>& snippets() const { return snippets_; }
    /// Of a file that was added, without their ends; the first is line 1.
    [[nodiscard]] const std::vector<std::string>& lines(const std::string& file) const { return files_.at(file); }

private:
    std::map<std::string, std::vector<std::string>> files_;
    std::vector<Snippet> snippets_;
};

} // namespace shadowlab
