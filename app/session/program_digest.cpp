// SPDX-License-Identifier: MIT
#include "app/session/program_digest.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "app/session/assets.h"
#include "app/session/digest.h"
#include "app/session/plugins.h"
#include "techniques/foundation/gl/added_shaders.h"
#include "techniques/foundation/gl/shader_text.h"

namespace shadowlab::session {

namespace {

std::string digestOfFile(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return digestOf(std::string(std::istreambuf_iterator<char>(stream), {}));
}

} // namespace

std::string programDigest() {
    std::string all = SHADOWLAB_VERSION + digestOfFile("/proc/self/exe");
    for (const LoadedPlugin& plugin : loadedPlugins())
        all += digestOfFile(plugin.file);
    for (const gl::EmbeddedShader& shader : gl::allShaders())
        all += digestOf(gl::shaderText(shader.name).value_or(""));
    std::vector<std::filesystem::path> fonts;
    std::error_code ignored; // without fonts nothing is drawn, and who draws says so
    for (const auto& entry : std::filesystem::directory_iterator(assetsRoot() / "fonts", ignored))
        fonts.push_back(entry.path());
    std::ranges::sort(fonts);
    for (const std::filesystem::path& font : fonts)
        all += digestOfFile(font);
    return digestOf(all);
}

} // namespace shadowlab::session
