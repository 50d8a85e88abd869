// The geometry shader that hands a vertex shader's outputs on, where a driver needs one to count triangles.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/primitive_id.h"

#include <gtest/gtest.h>

#include "techniques/foundation/gl/shader_source.h"

namespace shadowlab::gl {
namespace {

TEST(PrimitiveId, EachOutputIsHandedOnUnderItsName) {
    const HandingOn handing =
        handingOn("#version 330 core\nin vec3 a;\nout vec3 positionView;\nout vec2 uv;\nvoid main() {}\n", {});
    EXPECT_EQ(handing.vertexDefines, (std::vector<std::string>{"positionView positionViewOfVertex", "uv uvOfVertex"}));
    for (const char* line : {"in vec3 positionViewOfVertex[];\nout vec3 positionView;\n",
                             "        uv = uvOfVertex[i];\n", "gl_PrimitiveID = gl_PrimitiveIDIn;"})
        EXPECT_NE(handing.geometryText.find(line), std::string::npos) << line << " in\n" << handing.geometryText;
}

TEST(PrimitiveId, WhatThePreprocessorLeavesOutIsNotHandedOn) {
    const std::string text = shaderSource("surface.vert").text;
    const std::vector<std::string> cutting = {"CUT_HOLES"};
    EXPECT_EQ(handingOn(text, {}).geometryText.find("texcoord"), std::string::npos);
    EXPECT_NE(handingOn(text, cutting).geometryText.find("in vec2 texcoordOfVertex[];"), std::string::npos);
    EXPECT_EQ(handingOn(text, cutting).vertexDefines.size(), handingOn(text, {}).vertexDefines.size() + 1);
}

} // namespace
} // namespace shadowlab::gl
