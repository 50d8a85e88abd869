// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/shader_source.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>
#include <utility>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::gl {

namespace {

struct AddedShaders {
    std::vector<EmbeddedShader> shaders;
    std::vector<std::string> folders;
    bool readFolders = false;
};
AddedShaders& added() {
    static AddedShaders all;
    return all;
}

// No hand-written shader is larger; a larger file is a mistake.
constexpr std::uint64_t kLargestFile = std::uint64_t{1} << 20;

/// Nothing where there is no such file.
std::optional<std::string> textOfFile(const std::string& path) {
    std::error_code failed;
    if (!std::filesystem::exists(path, failed) && !failed) return std::nullopt;
    try {
        std::string text = scene::readFile(path, kLargestFile); // does not block on a FIFO or a device
        constexpr std::string_view kByteOrderMark =
            "\xEF\xBB\xBF"; // some editors begin with one; compilers stumble over it
        if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
        if (const std::size_t nul = text.find('\0'); nul != std::string::npos)
            throw Error(ExitStatus::badInput,
                        scene::shownPath(path) + ":" +
                            std::to_string(
                                1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(nul), '\n')) +
                            ": holds a NUL byte, so it is no text; save it again");
        return text;
    } catch (const Error& fault) {
        throw Error(ExitStatus::badInput, fault.what());
    }
}

std::string readText(std::string_view name, const std::string& includedFrom) {
    if (std::optional<std::string> text = shaderText(name)) return std::move(*text);
    std::vector<std::string> known;
    for (const EmbeddedShader& shader : allShaders())
        known.emplace_back(shader.name);
    // A list of all hundred names would not help.
    throw Error(ExitStatus::badInput,
                includedFrom + "includes \"" + std::string(name) + "\", which does not exist; " +
                    (nearestNames(name, known).empty() ? "fix the name, or add the file" : suggestion(name, known)));
}

struct Resolver {
    std::span<const Substitution> substitutions;
    ShaderSource result;

    /// Appends the file, a `#line` before it and after each include, so that numbers stay true.
    void append(std::string_view name, const std::string& includedFrom) {
        if (std::ranges::find(result.files, name) != result.files.end()) return;
        const std::size_t number = result.files.size();
        result.files.emplace_back(name);
        std::istringstream lines(readText(name, includedFrom));
        std::string line;
        const auto lineDirective = [&](std::size_t lineNumber) {
            return "#line " + std::to_string(number * ShaderSource::kLinesPerFile + lineNumber) + "\n";
        };
        if (number > 0) result.text += lineDirective(1);
        for (int lineNumber = 1; std::getline(lines, line); ++lineNumber) {
            if (!line.starts_with("#include")) {
                result.text += line + "\n";
                continue;
            }
            const std::string place = std::string(name) + ":" + std::to_string(lineNumber) + ": ";
            const std::size_t open = line.find('"'), close = line.rfind('"');
            if (open == std::string::npos || close <= open)
                throw Error(ExitStatus::badInput, place + "malformed #include; write #include \"file.glsl\"");
            std::string wanted = line.substr(open + 1, close - open - 1);
            for (const Substitution& substitution : substitutions)
                if (wanted == substitution.includeName) wanted = substitution.file;
            append(wanted, place);
            result.text += lineDirective(static_cast<std::size_t>(lineNumber) + 1);
        }
    }
};

} // namespace

std::vector<EmbeddedShader> allShaders() {
    const std::span<const EmbeddedShader> ours = embeddedShaders();
    std::vector<EmbeddedShader> shaders(ours.begin(), ours.end());
    shaders.insert(shaders.end(), added().shaders.begin(), added().shaders.end());
    return shaders;
}

void addShaders(std::span<const EmbeddedShader> shaders, std::string folder) {
    added().shaders.insert(added().shaders.end(), shaders.begin(), shaders.end());
    added().folders.push_back(std::move(folder));
}

const std::vector<std::string>& addedShaderFolders() { return added().folders; }

void readAddedShadersFromFolders() { added().readFolders = true; }

std::optional<std::string> shaderText(std::string_view name) {
    const auto textIn = [&](const std::string& folder) { return textOfFile(folder + "/" + std::string(name)); };
    if (const char* folder = std::getenv("SHADOWLAB_SHADERS"))
        if (std::optional<std::string> text = textIn(folder)) return text;
    for (const EmbeddedShader& shader : embeddedShaders())
        if (shader.name == name) return std::string(shader.text);
    for (const EmbeddedShader& shader : added().shaders) {
        if (shader.name != name) continue;
        for (const std::string& folder : added().folders)
            if (std::optional<std::string> text = textIn(folder); text && added().readFolders) return text;
        return std::string(shader.text);
    }
    return std::nullopt;
}

ShaderSource shaderSource(std::string_view name, std::span<const std::string> defines,
                          std::span<const Substitution> substitutions) {
    Resolver resolver{substitutions, {}};
    resolver.append(name, "");
    if (!defines.empty()) {
        // The #version line must stay first; definitions follow it and the count resumes at line 2.
        const std::size_t afterVersion = resolver.result.text.find('\n') + 1;
        std::string block;
        for (const std::string& define : defines)
            block += "#define " + define + "\n";
        resolver.result.text.insert(afterVersion, block + "#line 2\n");
    }
    return std::move(resolver.result);
}

std::string withFileNames(std::string_view log, const ShaderSource& source) {
    static const std::regex place(R"(^(?:ERROR: |WARNING: )?(\d+)[:(](\d+)\)?(?:\(\d+\))? ?:? ?)");
    std::istringstream lines{std::string(log)};
    std::string line, text;
    while (std::getline(lines, line)) {
        std::smatch match;
        if (std::regex_search(line, match, place)) {
            const unsigned long at = std::stoul(match[2]), number = at / ShaderSource::kLinesPerFile;
            if (number < source.files.size())
                line = source.files[number] + ":" + std::to_string(at % ShaderSource::kLinesPerFile) + ": " +
                       match.suffix().str();
        }
        text += line + "\n";
    }
    return text;
}

} // namespace shadowlab::gl
