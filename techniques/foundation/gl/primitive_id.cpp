// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/primitive_id.h"

#include <algorithm>
#include <sstream>

#include "techniques/foundation/gl/handle.h"

namespace shadowlab::gl {

namespace {

struct Output {
    std::string type, name;
};

/// The lines "out TYPE NAME;" that the preprocessor leaves. Conditions are #ifdef and #ifndef alone, as in all our vertex
/// shaders.
std::vector<Output> outputsOf(std::string_view text, std::span<const std::string> defines) {
    const auto isDefined = [&](const std::string& name) {
        return std::ranges::any_of(defines, [&](const std::string& define) {
            return define == name || define.starts_with(name + " ");
        });
    };
    std::vector<Output> outputs;
    std::vector<bool> holds; // of each condition around the line
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string first, type, name;
        words >> first >> type >> name;
        if (first == "#ifdef" || first == "#ifndef") holds.push_back(isDefined(type) == (first == "#ifdef"));
        if (first == "#else") holds.back() = !holds.back();
        if (first == "#endif") holds.pop_back();
        if (first != "out" || std::ranges::find(holds, false) != holds.end()) continue;
        outputs.push_back({type, name.substr(0, name.find(';'))});
    }
    return outputs;
}

} // namespace

bool losesPrimitiveId() {
    const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return renderer && std::string_view(renderer).find("softpipe") != std::string_view::npos;
}

HandingOn handingOn(std::string_view vertexText, std::span<const std::string> defines) {
    constexpr std::string_view kRenamed = "OfVertex";
    HandingOn result;
    std::string declarations, copies;
    for (const auto& [type, name] : outputsOf(vertexText, defines)) {
        const std::string ofVertex = name + std::string(kRenamed);
        result.vertexDefines.push_back(name + " " + ofVertex);
        declarations += "in " + type + " " + ofVertex + "[];\nout " + type + " " + name + ";\n";
        copies += "        " + name + " = " + ofVertex + "[i];\n";
    }
    result.geometryText = "#version 330 core\n"
                          "layout(triangles) in;\n"
                          "layout(triangle_strip, max_vertices = 3) out;\n"
                          "invariant gl_Position;\n" +
                          declarations +
                          "void main() {\n"
                          "    for (int i = 0; i < 3; ++i) {\n"
                          "        gl_Position = gl_in[i].gl_Position;\n"
                          "        gl_PrimitiveID = gl_PrimitiveIDIn;\n" +
                          copies +
                          "        EmitVertex();\n"
                          "    }\n"
                          "    EndPrimitive();\n"
                          "}\n";
    return result;
}

} // namespace shadowlab::gl
