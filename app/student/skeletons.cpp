// In a skeleton's files, and in their names, `my_shadows` stands for the namespace, `my-shadows` for the id, `My shadows` for the
// title: so each is C++ and GLSL that editors and compilers take as it is.
// SPDX-License-Identifier: MIT
#include "app/student/skeletons.h"

#include <algorithm>
#include <array>

#include "app/context/assets.h"
#include "app/picture/limits.h"
#include "app/student/blanks.h"
#include "app/student/lecture_files.h"
#include "app/student/plugins.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/registry.h"

namespace shadowlab::student {

namespace {

namespace fs = std::filesystem;

// Twice as long as any of ours: it stands in tables and on labels.
constexpr std::size_t kLongestTechniqueName = 40;

// Namespaces that a technique's own would be mixed up with, and words that no namespace can have.
constexpr std::array kTaken = {"cli",  "context", "course", "drawing", "figures", "film",      "foreign", "gl",  "glm",
                               "hard", "image",   "judge",  "lab",     "look",    "params",    "std", "picture",
                               "report", "scene", "student", "trace",  "window",  "shadowlab"};
constexpr std::array kWords = {
    "alignas",   "alignof",  "and",      "asm",     "auto",      "bitand",    "bitor",    "bool",      "break",
    "case",      "catch",    "char",     "class",   "compl",     "concept",   "const",    "consteval", "constexpr",
    "constinit", "continue", "decltype", "default", "delete",    "do",        "double",   "else",      "enum",
    "explicit",  "export",   "extern",   "false",   "float",     "for",       "friend",   "goto",      "if",
    "inline",    "int",      "long",     "main",    "mutable",   "namespace", "new",      "noexcept",  "not",
    "nullptr",   "operator", "or",       "private", "protected", "public",    "register", "requires",  "return",
    "short",     "signed",   "sizeof",   "static",  "struct",    "switch",    "template", "this",      "throw",
    "true",      "try",      "typedef",  "typeid",  "typename",  "union",     "unsigned", "using",     "virtual",
    "void",      "volatile", "while",    "xor"};

std::string namespaceOf(std::string name) {
    std::ranges::replace(name, '-', '_');
    return name;
}

/// "My shadows"
std::string titleOf(std::string name) {
    std::ranges::replace(name, '-', ' ');
    name.front() = static_cast<char>(name.front() - 'a' + 'A');
    return name;
}

std::string renamed(std::string text, const std::string& name) {
    const std::array<std::pair<std::string, std::string>, 3> words = {
        {{"my_shadows", namespaceOf(name)}, {"my-shadows", name}, {"My shadows", titleOf(name)}}};
    for (const auto& [from, to] : words)
        replaceAll(text, from, to);
    return text;
}

std::string textOf(const fs::path& file) {
    if (const std::string why = scene::whyUnreadable(file); !why.empty())
        throw Error(ExitStatus::badInput, file.string() + ": " + why + "; install shadowlab again");
    return scene::readFile(file, picture::limits().sceneFileBytes, "scene-file");
}

fs::path skeletonsFolder() { return context::assetsRoot() / "skeletons"; }

std::map<std::string, std::string> filesOfFolder(const fs::path& folder) {
    std::map<std::string, std::string> files;
    try {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
            if (!entry.is_directory()) files.emplace(fs::relative(entry.path(), folder).string(), textOf(entry.path()));
    } catch (const fs::filesystem_error& fault) {
        throw Error(ExitStatus::badInput,
                    folder.string() + ": cannot be read: " + fault.code().message() + "; install shadowlab again");
    }
    return files;
}

std::string tableOf(const Skeleton& skeleton, const SourceFiles& source) {
    std::string table = "| blank | where | the lecture's idea | when it is right |\n|---|---|---|---|\n";
    for (std::size_t i = 0; i < skeleton.blanks.size(); ++i) {
        const Blank& blank = skeleton.blanks[i];
        table += "| " + std::to_string(i + 1) + " | `" + nameInPlugin(findLines(source, blank).file, skeleton.source) +
                 "` | " + blank.idea + " | " + blank.whenRight + " |\n";
    }
    return table;
}

/// What stands between two @ in the files of assets/skeletons/with_blanks.
std::string filledTemplate(std::string text, const std::map<std::string, std::string>& values) {
    for (const auto& [name, value] : values)
        if (const std::size_t at = text.find("@" + name + "@"); at != std::string::npos)
            text.replace(at, name.size() + 2, value);
    return text;
}

fs::path descriptionOf(const std::string& skeleton) { return skeletonsFolder() / (skeleton + ".json"); }

std::map<std::string, std::string> filesWithBlanks(const Skeleton& skeleton) {
    const SourceFiles whole = lectureFiles(skeleton.source);
    SourceFiles blanked = whole;
    makeBlanks(blanked, skeleton.blanks);
    std::map<std::string, std::string> files = asPlugin(blanked, skeleton.source);
    files.at("technique.cpp")
        .insert(0, "// " + skeleton.title + ", with " + std::to_string(skeleton.blanks.size()) +
                       " blanks to be filled in; README.md lists them. The rest is the lecture's algorithm.\n//\n");
    for (const auto& [name, text] : filesOfFolder(skeletonsFolder() / "with_blanks"))
        files.emplace(name, filledTemplate(text, {{"TITLE", skeleton.title},
                                                  {"COUNT", std::to_string(skeleton.blanks.size())},
                                                  {"SCENE", skeleton.scene},
                                                  {"FAMILY", skeleton.family},
                                                  {"TABLE", tableOf(skeleton, whole)}}));
    return files;
}

} // namespace

std::vector<std::string> skeletonNames() {
    return {"empty", "planar", "shadow-map", "z-fail", "ray-tracing", "radiosity"};
}

std::map<std::string, std::string> skeletonFiles(const std::string& skeleton) {
    return skeleton == "empty" ? filesOfFolder(skeletonsFolder() / skeleton)
                               : filesWithBlanks(readSkeleton(descriptionOf(skeleton)));
}

std::string sceneToTry(const std::string& skeleton) {
    return skeleton == "empty" ? "sphere-on-plane" : readSkeleton(descriptionOf(skeleton)).scene;
}

std::string skeletonOf(const Plugin& plugin) {
    std::string text;
    for (const EmbeddedSource& source : plugin.sources)
        text += source.text;
    for (const gl::EmbeddedShader& shader : plugin.shaders)
        text += shader.text;
    // Of an anchor all but its beginning is kept, whatever the technique is called.
    const auto has = [&](const Blank& blank) { return text.find("-" + withoutLecture(blank.anchor) + "]") != std::string::npos; };
    for (const std::string& name : skeletonNames())
        if (name != "empty" && std::ranges::all_of(readSkeleton(descriptionOf(name)).blanks, has)) return name;
    return {};
}

void requireFreeName(const std::string& name) {
    const auto refuse = [&](const std::string& why) {
        throw Error(ExitStatus::usage, "new-technique: '" + name + "' " + why);
    };
    if (!isKebabCase(name))
        refuse("is no name of a technique; use small letters, digits and hyphens between them, as my-shadows");
    if (name.size() > kLongestTechniqueName)
        refuse("has " + std::to_string(name.size()) + " characters; use at most " +
               std::to_string(kLongestTechniqueName));
    const std::string space = namespaceOf(name);
    if (std::ranges::find(kWords, space) != kWords.end() || std::ranges::find(kTaken, space) != kTaken.end())
        refuse("cannot be the name of a namespace beside those of the program; choose another, as my-" + name);
    for (const RegisteredTechnique& technique : registeredTechniques())
        if (technique.info->id == name || technique.folder == space)
            refuse("is the name of a technique that there is already; choose another, as my-" + name);
}

void writeSkeleton(const std::string& skeleton, const std::string& name, const fs::path& folder) {
    requireFreeName(name);
    const std::map<std::string, std::string> files = skeletonFiles(skeleton);
    image::writeFolder(folder, [&](const fs::path& made) {
        for (const auto& [file, text] : files) {
            const fs::path place = made / renamed(file, name);
            image::makeFolders(place.parent_path());
            image::writeWhole(place, renamed(text, name));
        }
    });
}

} // namespace shadowlab::student
