// Every backend gives OpenGL 3.3, in any order within one process, and the same bytes.
// Only the window may be skipped, where there is no display, and OSMesa where Mesa has ended it (tests/support/osmesa.h).
// SPDX-License-Identifier: MIT
#include "app/context/context.h"

#include <glad/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <vector>

#include "app/context/window_context.h"
#include "techniques/foundation/base/error.h"
#include "tests/support/osmesa.h"

namespace shadowlab::context {
namespace {

constexpr int kSide = 8;

bool hasDisplay() {
    const char* display = std::getenv("DISPLAY");
    return display && *display;
}

/// Those that need no display.
std::vector<Backend> withoutDisplay() {
    if (testing::mayLackOsmesa()) return {Backend::egl};
    return {Backend::egl, Backend::osmesa};
}

/// Clears a framebuffer of our own in two colours and reads it back.
std::vector<std::uint8_t> clearedBytes() {
    GLuint texture = 0, framebuffer = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSide, kSide, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
    glViewport(0, 0, kSide, kSide);
    glClearColor(0.25f, 0.5f, 0.75f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(1, 2, 3, 4);
    glClearColor(1.0f, 0.0f, 0.1f, 0.5f);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST); // for the next time in the same context
    std::vector<std::uint8_t> bytes(std::size_t{kSide} * kSide * 4);
    glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
    return bytes;
}

std::vector<std::uint8_t> expectedBytes() {
    std::vector<std::uint8_t> bytes;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const bool inside = x >= 1 && x < 4 && y >= 2 && y < 6;
            const std::array<std::uint8_t, 4> color =
                inside ? std::array<std::uint8_t, 4>{255, 0, 26, 128} : std::array<std::uint8_t, 4>{64, 128, 191, 255};
            bytes.insert(bytes.end(), color.begin(), color.end());
        }
    return bytes;
}

void expectWorks(Backend backend, std::string_view name) {
    const auto context = createContext(backend);
    EXPECT_EQ(context->backend(), name);
    GLint major = 0, minor = 0, profile = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_GE(major * 10 + minor, 33) << glVersion();
    EXPECT_TRUE(profile & GL_CONTEXT_CORE_PROFILE_BIT) << glVersion();
    EXPECT_FALSE(glRenderer().empty());
    EXPECT_TRUE(clearedBytes() == expectedBytes());
}

TEST(Context, Egl) { expectWorks(Backend::egl, "egl"); }
TEST(Context, OsMesa) {
    if (testing::mayLackOsmesa()) GTEST_SKIP() << testing::kNoOsmesa;
    expectWorks(Backend::osmesa, "osmesa");
}
TEST(Context, Window) {
    if (!hasDisplay()) GTEST_SKIP() << "no DISPLAY: run under xvfb-run to test the window";
    expectWorks(Backend::window, "window");
}

TEST(Context, OneAfterTheOther) {
    if (testing::mayLackOsmesa()) GTEST_SKIP() << testing::kNoOsmesa;
    if (hasDisplay()) expectWorks(Backend::window, "window");
    expectWorks(Backend::osmesa, "osmesa");
    expectWorks(Backend::egl, "egl");
    expectWorks(Backend::osmesa, "osmesa");
    if (hasDisplay()) expectWorks(Backend::window, "window");
}

TEST(Context, SeveralAliveAtOnce) {
    std::vector<std::unique_ptr<Context>> contexts;
    std::vector<Backend> backends = withoutDisplay();
    std::ranges::copy(withoutDisplay(), std::back_inserter(backends)); // two of each
    if (hasDisplay()) backends.push_back(Backend::window);
    for (const Backend backend : backends)
        contexts.push_back(createContext(backend));
    for (int round = 0; round < 3; ++round)
        for (const auto& context : contexts) {
            context->makeCurrent();
            EXPECT_TRUE(clearedBytes() == expectedBytes()) << context->backend();
        }
    // One that is destroyed does not take the current one with it.
    contexts.front()->makeCurrent();
    while (contexts.size() > 1) {
        contexts.pop_back();
        EXPECT_TRUE(clearedBytes() == expectedBytes());
    }
}

TEST(Context, DebugContextsWorkToo) {
    for (const Backend backend : withoutDisplay()) {
        const auto context = createContext(backend, true);
        EXPECT_TRUE(clearedBytes() == expectedBytes()) << context->backend();
    }
}

TEST(Context, AutomaticNeedsNoDisplay) {
    const auto context = createContext(Backend::automatic);
    EXPECT_EQ(context->backend(), "egl");
}

TEST(Context, ProbeReportsAllAndRestoresTheCurrentOne) {
    const auto context = createContext(withoutDisplay().back());
    const auto reports = probeBackends();
    ASSERT_EQ(reports.size(), 3u);
    for (const BackendReport& report : reports) {
        const bool expected =
            (report.name != "window" || hasDisplay()) && (report.name != "osmesa" || !testing::mayLackOsmesa());
        EXPECT_EQ(report.available, expected) << report.name << ": " << report.reason;
        EXPECT_EQ(report.available, !report.version.empty());
        EXPECT_EQ(report.available, report.remedy.empty());
    }
    EXPECT_TRUE(clearedBytes() == expectedBytes());
}

TEST(Context, NamesAreChecked) {
    EXPECT_EQ(backendFromName("auto"), Backend::automatic);
    EXPECT_EQ(backendFromName("osmesa"), Backend::osmesa);
    EXPECT_THROW(static_cast<void>(backendFromName("OSMesa")), Error);
}

/// Mesa looks at the variable once in a process, so the test starts itself again with it set.
TEST(Context, OldDriverIsNamed) {
    constexpr const char* variable = "MESA_GL_VERSION_OVERRIDE";
    if (!std::getenv(variable)) {
        const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
        const std::string again = std::string(variable) + "=2.1 '" + self + "' --gtest_filter=Context.OldDriverIsNamed";
        EXPECT_EQ(std::system(again.c_str()), 0);
        return;
    }
    std::vector<Backend> backends = withoutDisplay();
    backends.push_back(Backend::automatic);
    for (const Backend backend : backends) {
        try {
            const auto context = createContext(backend);
            ADD_FAILURE() << "got " << glVersion();
        } catch (const Error& error) {
            const std::string text = error.what();
            EXPECT_EQ(error.status(), ExitStatus::noContext);
            EXPECT_NE(text.find("OpenGL 2.1"), std::string::npos) << text;
            EXPECT_NE(text.find(variable), std::string::npos) << text;
            EXPECT_EQ(text.find('\n'), std::string::npos) << text;
        }
    }
}

TEST(Context, WindowWithoutDisplayIsACleanError) {
    if (hasDisplay()) GTEST_SKIP() << "there is a display";
    try {
        const auto context = createContext(Backend::window);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::noContext);
        EXPECT_NE(std::string(error.what()).find("--backend egl"), std::string::npos) << error.what();
    }
}

TEST(Context, WindowThatCannotBeTellsItsReasonAlone) {
    if (hasDisplay()) GTEST_SKIP() << "there is a display";
    try {
        const auto context = createWindowContext({});
        FAIL();
    } catch (const NoWindow& none) {
        EXPECT_EQ(none.reason.find(';'), std::string::npos) << none.reason;
        EXPECT_NE(std::string(none.what()).find(none.reason), std::string::npos) << none.what();
    }
}

} // namespace
} // namespace shadowlab::context
