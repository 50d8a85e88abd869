// SPDX-License-Identifier: MIT
#include "app/student/lecture_files.h"

#include <algorithm>
#include <regex>
#include <set>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/gl/shader_source.h"
#include "techniques/source_text.h"

namespace shadowlab::student {

namespace {

constexpr std::string_view kLecture = "techniques/lecture/", kShaders = "shaders/lecture/";
// The list of all six algorithms: a plug-in has a list of its own.
constexpr std::string_view kListOfLecture = "techniques/lecture/lecture.h";

/// As it was when the program was built; nullptr: there is no such file.
const std::string_view* embeddedText(const std::string& name) {
    for (const EmbeddedSource& file : embeddedSources())
        if (file.name == name) return &file.text;
    for (const gl::EmbeddedShader& shader : gl::embeddedShaders())
        if ("shaders/" + std::string(shader.name) == name) return &shader.text;
    return nullptr;
}

void addWithNeeds(SourceFiles& files, const std::string& name) {
    const std::string_view* const embedded = embeddedText(name);
    if (!embedded)
        throw Error(ExitStatus::bug, name + " is not in the program; embed it (techniques/embed_sources.cmake)");
    if (!files.emplace(name, *embedded).second) return;
    const std::string text(*embedded);
    static const std::regex header(R"re(#include "(techniques/lecture/[\w/]+)\.h")re");
    for (std::sregex_iterator match(text.begin(), text.end(), header), end; match != end; ++match) {
        const std::string stem = (*match)[1];
        if (stem + ".h" == kListOfLecture) continue;
        addWithNeeds(files, stem + ".h");
        if (embeddedText(stem + ".cpp")) addWithNeeds(files, stem + ".cpp");
    }
    static const std::regex shader(R"re("(lecture/\w+\.(?:glsl|vert|frag))")re");
    for (std::sregex_iterator match(text.begin(), text.end(), shader), end; match != end; ++match)
        addWithNeeds(files, "shaders/" + (*match)[1].str());
}

/// "lecture-light-on" -> "my-shadows-light-on": each anchor stands in one place of the program and all plug-ins.
std::string anchorInPlugin(const std::string& anchor) { return "my-shadows-" + withoutLecture(anchor); }

/// Gives the anchors new names where they stand, and where the passes name them (PassInfo::anchors).
std::string withOwnAnchors(const std::string& text, const std::set<std::string>& anchors) {
    static const std::regex uses(R"(// \[anchor: [^\]]*\]|\.anchors = [^}]*\})"), word("[a-z0-9-]+");
    std::string result;
    auto copied = text.begin();
    for (std::sregex_iterator use(text.begin(), text.end(), uses), end; use != end; ++use) {
        result.append(copied, (*use)[0].first);
        auto part = (*use)[0].first;
        for (std::sregex_iterator one((*use)[0].first, (*use)[0].second, word), last; one != last; ++one) {
            result.append(part, (*one)[0].first);
            result += anchors.contains(one->str()) ? anchorInPlugin(one->str()) : one->str();
            part = (*one)[0].second;
        }
        result.append(part, (*use)[0].second);
        copied = (*use)[0].second;
    }
    return result.append(copied, text.end());
}

/// The description of the technique: a plug-in's own id and title; what the program alone sorts its lists by is left out.
std::string withOwnDescription(std::string text, const std::string& idInLecture) {
    replaceAll(text, idInLecture, "my-shadows");
    static const std::regex title(R"re(\.title = "Lecture: [^"]*")re"),
        sorted(R"(\n *\.(?:order|group|sister) = [^\n]*)");
    return std::regex_replace(std::regex_replace(text, title, R"(.title = "My shadows")"), sorted, "");
}

} // namespace

std::string withoutLecture(const std::string& anchor) {
    constexpr std::string_view kPrefix = "lecture-";
    return anchor.starts_with(kPrefix) ? anchor.substr(kPrefix.size()) : anchor;
}

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

std::string nameInPlugin(const std::string& name, const std::string& source) {
    if (name.starts_with(kShaders)) return "shaders/my_shadows/" + name.substr(kShaders.size());
    if (name == std::string(kLecture) + source + ".cpp") return "technique.cpp";
    if (name == std::string(kLecture) + "words/" + source + ".h") return "words.h";
    return name.substr(name.rfind('/') + 1);
}

SourceFiles lectureFiles(const std::string& source) {
    const std::string name = std::string(kLecture) + source + ".cpp";
    if (!embeddedText(name))
        throw Error(ExitStatus::badInput, "there is no algorithm " + name + "; name one of techniques/lecture");
    SourceFiles files;
    addWithNeeds(files, name);
    return files;
}

SourceFiles asPlugin(const SourceFiles& files, const std::string& source) {
    std::set<std::string> anchors;
    const SourceText all = asSourceText(files);
    for (const Snippet& snippet : all.snippets())
        anchors.insert(snippet.anchor);

    const std::string main = std::string(kLecture) + source + ".cpp";
    static const std::regex idForm(R"re(\.id = "(lecture-[a-z-]+)")re"), infoForm(R"(const TechniqueInfo& (\w+)\(\))");
    std::smatch id, info;
    if (!std::regex_search(files.at(main), id, idForm) || !std::regex_search(files.at(main), info, infoForm))
        throw Error(ExitStatus::bug, main + ": no TechniqueInfo with an id is found; write `.id = \"lecture-NAME\"`");

    SourceFiles plugin;
    for (const auto& [name, original] : files) {
        std::string text = withOwnDescription(withOwnAnchors(original, anchors), id[1]);
        replaceAll(text, "#include \"" + std::string(kListOfLecture) + "\"\n", "");
        for (const auto& [other, ignored] : files) {
            const std::string to = nameInPlugin(other, source);
            replaceAll(text, other, to);
            if (other.starts_with(kLecture)) replaceAll(text, other.substr(std::string_view("techniques/").size()), to);
            if (other.starts_with(kLecture)) replaceAll(text, other.substr(kLecture.size()), to);
        }
        replaceAll(text, "shadowlab::lecture", "shadowlab::my_shadows");
        replaceAll(text, "\"lecture/", "\"my_shadows/");
        if (name == main) // before the end of its last namespace
            text.insert(text.rfind("\n} // namespace"),
                        "\nstd::span<const TechniqueInfo> techniques() { return {&" + info[1].str() + "(), 1}; }\n");
        plugin.emplace(nameInPlugin(name, source), std::move(text));
    }
    return plugin;
}

} // namespace shadowlab::student
