// What the other tests ask of every draw call, asked of draw calls that have just these faults; and that the driver's own
// complaints are heard.
// SPDX-License-Identifier: MIT
#include "tests/support/strict_draws.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/framebuffer.h"
#include "techniques/foundation/gl/program.h"
#include "techniques/foundation/gl/texture.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab {
namespace {

class StrictDraws : public testing::GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        gl::setBaselineState();
        target_ = gl::Texture2D(GL_RGBA16F, {4, 4}, "target");
        source_ = gl::Texture2D(GL_RGBA16F, {4, 4}, "source");
        framebuffer_ = gl::Framebuffer(&target_, nullptr, "target");
        framebuffer_.bind();
        glDisable(GL_DEPTH_TEST);
    }
    void TearDown() override {
        framebuffer_ = {};
        target_ = {};
        source_ = {};
        GlTest::TearDown();
    }
    static void drawGreyed(int unit) {
        const gl::Program program("fullscreen.vert", "greyed.frag");
        program.use();
        if (unit >= 0) program.set("source", unit);
        gl::drawFullscreenTriangle();
    }
    static void expectFault(const std::string& expected) {
        const std::string found = testing::takeDrawFaults();
        EXPECT_NE(found.find(expected), std::string::npos) << found;
        EXPECT_EQ(std::ranges::count(found, '\n'), 1) << found;
    }
    gl::Texture2D target_, source_;
    gl::Framebuffer framebuffer_;
};

TEST_F(StrictDraws, WhatIsAsItShouldBeIsNoFault) {
    source_.bind(0);
    drawGreyed(0);
    EXPECT_EQ(testing::takeDrawFaults(), "");
}

TEST_F(StrictDraws, ASamplerWithoutATexture) {
    drawGreyed(-1);
    expectFault("has no texture");
}

TEST_F(StrictDraws, ATextureThatIsReadAndWritten) {
    target_.bind(0);
    drawGreyed(0);
    expectFault("a part of the target");
}

TEST_F(StrictDraws, ATextureWithoutItsSmallerLevels) {
    source_.bind(0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    drawGreyed(0);
    expectFault("incomplete");
}

TEST_F(StrictDraws, WholeNumbersReadAsOthers) {
    const gl::Texture2D numbers(GL_R32UI, {4, 4}, "numbers");
    numbers.bind(0);
    drawGreyed(0);
    expectFault("not what the sampler reads");
}

TEST_F(StrictDraws, AClipDistanceThatIsNotWritten) {
    source_.bind(0);
    glEnable(GL_CLIP_DISTANCE1);
    drawGreyed(0);
    glDisable(GL_CLIP_DISTANCE1);
    expectFault("clip distance 1");
}

TEST_F(StrictDraws, NoVertexArray) {
    source_.bind(0);
    const gl::Program program("fullscreen.vert", "greyed.frag");
    program.use();
    program.set("source", 0);
    glBindVertexArray(0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    EXPECT_NE(testing::takeDrawFaults().find("no vertex array"), std::string::npos);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    EXPECT_NE(gl::takeDebugMessages(), "");
}

TEST_F(StrictDraws, AProgramThatIsDeletedWhileInUse) {
    const GLuint program = glCreateProgram();
    for (const GLenum type : {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER}) {
        const GLuint shader = glCreateShader(type);
        const char* text = type == GL_VERTEX_SHADER ? "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n"
                                                    : "#version 330 core\nout vec4 result;\nvoid main() { result = vec4(1.0); }\n";
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    glUseProgram(program);
    glDeleteProgram(program);
    expectFault("deleted while it is in use");
    glUseProgram(0);
    // gl::Program ends the use first.
    source_.bind(0);
    drawGreyed(0);
    GLint inUse = -1;
    glGetIntegerv(GL_CURRENT_PROGRAM, &inUse);
    EXPECT_EQ(inUse, 0);
    EXPECT_EQ(testing::takeDrawFaults(), "");
}

TEST_F(StrictDraws, SamplersThatNoPassSetsShareNoUnit) {
    const gl::Program program("surface.vert", "shadow_map/decide.frag", {},
                              {{"shadow_map/layers/layer_one.glsl", "shadow_map/layers/layer_cube.glsl"}});
    program.use();
    std::set<GLint> units;
    for (const char* name :
         {"lightFacing", "firstTriangles", "shadowMap", "edgeDepths", "positionsLightRelative", "triangles"}) {
        GLint id = 0, unit = -1;
        glGetIntegerv(GL_CURRENT_PROGRAM, &id);
        glGetUniformiv(static_cast<GLuint>(id), glGetUniformLocation(static_cast<GLuint>(id), name), &unit);
        EXPECT_TRUE(units.insert(unit).second) << name << " shares unit " << unit;
    }
}

TEST_F(StrictDraws, AnErrorOfOpenGlIsHeard) {
    glEnable(GL_TEXTURE_2D); // no capability of a core profile
    EXPECT_NE(gl::takeDebugMessages(), "");
    EXPECT_THROW(gl::check("a planted error"), std::logic_error);
}

TEST_F(StrictDraws, TheContextIsForwardCompatible) {
    GLint flags = 0, profile = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_TRUE(flags & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT) << "EGL and windows ask for it";
    EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
    glLineWidth(2); // deprecated
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    EXPECT_NE(gl::takeDebugMessages(), "");
}

TEST_F(StrictDraws, OfMessagesTheSeriousOnesAreHeard) {
    const auto say = [](GLenum type, GLenum severity) {
        glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, type, 1, severity, -1, "planted");
        return gl::takeDebugMessages();
    };
    for (const GLenum severity : {GL_DEBUG_SEVERITY_HIGH, GL_DEBUG_SEVERITY_MEDIUM})
        for (const GLenum type :
             {GL_DEBUG_TYPE_ERROR, GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR, GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR})
            EXPECT_EQ(say(type, severity), "planted\n");
    EXPECT_EQ(say(GL_DEBUG_TYPE_PERFORMANCE, GL_DEBUG_SEVERITY_HIGH), "planted\n");
    EXPECT_EQ(say(GL_DEBUG_TYPE_PERFORMANCE, GL_DEBUG_SEVERITY_MEDIUM), "");
    EXPECT_EQ(say(GL_DEBUG_TYPE_OTHER, GL_DEBUG_SEVERITY_LOW), "");
}

} // namespace
} // namespace shadowlab
