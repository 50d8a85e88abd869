// SPDX-License-Identifier: MIT
#include "app/student/program_digest.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>
#include <vector>

#include "app/context/assets.h"
#include "app/picture/digest.h"
#include "app/student/plugins.h"
#include "techniques/foundation/gl/shader_source.h"
#include "techniques/foundation/scene/load/file_access.h"

namespace shadowlab::student {

namespace {

/// The program and what it has loaded already: no limit is for them.
std::string digestOfFile(const std::filesystem::path& file) {
    if (!scene::whyUnreadable(file).empty()) return {}; // a program may be run without being read
    return picture::digestOf(scene::readFile(file, std::numeric_limits<std::int64_t>::max()));
}

/// The texts of all shaders, and of what they include: an edited one may include files of its own.
std::string shaderTexts() {
    std::vector<std::string> names;
    for (const gl::EmbeddedShader& shader : gl::allShaders())
        names.emplace_back(shader.name);
    std::string all;
    std::set<std::string> seen;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!seen.insert(names[i]).second) continue;
        const std::string text = gl::shaderText(names[i]).value_or("");
        all += names[i] + "\n" + text;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);)
            if (const std::size_t open = line.find('"'), close = line.rfind('"');
                line.starts_with("#include") && close > open)
                names.push_back(line.substr(open + 1, close - open - 1));
    }
    return all;
}

} // namespace

std::string programDigest() {
    std::string all = SHADOWLAB_VERSION + digestOfFile("/proc/self/exe");
    for (const LoadedPlugin& plugin : loadedPlugins())
        all += digestOfFile(plugin.file);
    all += picture::digestOf(shaderTexts());
    std::vector<std::filesystem::path> fonts;
    std::error_code ignored; // without fonts nothing is drawn, and who draws says so
    for (const auto& entry : std::filesystem::directory_iterator(context::assetsRoot() / "fonts", ignored))
        if (entry.is_regular_file(ignored)) fonts.push_back(entry.path());
    std::ranges::sort(fonts);
    for (const std::filesystem::path& font : fonts)
        all += digestOfFile(font);
    return picture::digestOf(all);
}

} // namespace shadowlab::student
