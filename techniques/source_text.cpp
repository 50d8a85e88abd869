// SPDX-License-Identifier: MIT
#include "techniques/source_text.h"

#include <algorithm>
#include <regex>
#include <sstream>

#include "techniques/added_techniques.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/gl/shader_source.h"

namespace shadowlab {

namespace {

std::vector<EmbeddedSource>& added() {
    static std::vector<EmbeddedSource> sources;
    return sources;
}

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> lines;
    std::istringstream stream{std::string(text)};
    for (std::string line; std::getline(stream, line);) {
        if (line.ends_with('\r')) line.pop_back(); // an editor elsewhere may have saved it
        lines.push_back(std::move(line));
    }
    return lines;
}

bool isEmpty(const std::string& line) { return line.find_first_not_of(" \t") == std::string::npos; }

std::size_t indentOf(const std::string& line) { return line.find_first_not_of(" \t"); }

/// The snippet that begins with `lines[first]`; empty where nothing does.
LineRange paragraph(const std::vector<std::string>& lines, std::size_t first) {
    if (first >= lines.size() || isEmpty(lines[first])) return {};
    const std::size_t indent = indentOf(lines[first]);
    std::size_t last = first;
    for (std::size_t i = first + 1; i < lines.size(); ++i) {
        if (isEmpty(lines[i])) continue;
        const bool followsEmpty = isEmpty(lines[i - 1]);
        // A preprocessor's line stands at the left, whatever it is in the middle of: it ends what has been closed before it.
        if (lines[i].starts_with('#')) {
            if (followsEmpty || (lines[i - 1].starts_with('}') && indent == 0)) break;
        } else if (indentOf(lines[i]) < indent || (followsEmpty && indentOf(lines[i]) <= indent)) {
            break;
        }
        last = i;
    }
    return {static_cast<int>(first) + 1, static_cast<int>(last) + 1};
}

std::string placeOf(const Snippet& snippet) { return snippet.file + ":" + std::to_string(snippet.lines.first - 1); }

} // namespace

std::vector<AnchorUse> anchorsOf(const PassInfo& pass) {
    static const std::regex form(R"(([a-z0-9-]+)(?:\[([a-z0-9-]+)=([a-z0-9.-]+)\])?)");
    std::vector<AnchorUse> uses;
    std::istringstream words{std::string(pass.anchors)};
    for (std::string word; words >> word;) {
        std::smatch match;
        if (!std::regex_match(word, match, form))
            throw Error(ExitStatus::bug, "pass '" + std::string(pass.id) + "': '" + word +
                                             "' is no anchor; write NAME or NAME[PARAMETER=VALUE]");
        uses.push_back({match[1], match[2], match[3]});
    }
    return uses;
}

SourceText SourceText::read() {
    SourceText source;
    for (const gl::EmbeddedShader& shader : gl::allShaders())
        source.add("shaders/" + std::string(shader.name),
                   gl::shaderText(shader.name).value_or(std::string(shader.text)));
    for (const EmbeddedSource& file : embeddedSources())
        source.add(std::string(file.name), file.text);
    for (const EmbeddedSource& file : added())
        source.add(std::string(file.name), file.text);
    return source;
}

void addSources(std::span<const EmbeddedSource> sources) {
    added().insert(added().end(), sources.begin(), sources.end());
}

void SourceText::add(std::string file, std::string_view text) {
    static const std::regex anchor(R"(^\s*// \[anchor: ([a-z0-9-]+)\]\s*$)");
    std::vector<std::string> lines = linesOf(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (std::smatch match; std::regex_match(lines[i], match, anchor))
            snippets_.push_back({match[1], file, paragraph(lines, i + 1)});
    }
    files_[std::move(file)] = std::move(lines);
}

const Snippet& SourceText::at(std::string_view anchor) const {
    const auto is = [&](const Snippet& snippet) { return snippet.anchor == anchor; };
    const auto found = std::ranges::find_if(snippets_, is);
    if (found == snippets_.end()) {
        std::vector<std::string> known;
        for (const Snippet& snippet : snippets_)
            known.push_back(snippet.anchor);
        throw Error(ExitStatus::badInput,
                    "the source has no line `// [anchor: " + std::string(anchor) + "]`; " + suggestion(anchor, known));
    }
    if (const auto second = std::find_if(found + 1, snippets_.end(), is); second != snippets_.end())
        throw Error(ExitStatus::badInput, placeOf(*second) + ": the anchor '" + std::string(anchor) + "' stands in " +
                                              placeOf(*found) + " as well; give one of them another name");
    if (found->lines.first == 0)
        throw Error(ExitStatus::badInput, found->file + ": the anchor '" + std::string(anchor) +
                                              "' has no lines after it; put it right before them");
    return *found;
}

} // namespace shadowlab
