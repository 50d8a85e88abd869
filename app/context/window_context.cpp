// GLFW: the context of the program's window, and, hidden, the third way to render without showing anything.
// SPDX-License-Identifier: MIT
#include "app/context/window_context.h"

#define GLFW_INCLUDE_NONE // GL comes from glad, never from the system's GL/gl.h
#include <GLFW/glfw3.h>

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>

#include "app/context/backends.h"
#include "app/context/display_loss.h"
#include "app/context/mesa.h"

namespace shadowlab::context {
namespace {

/// GLFW's last complaint, without its line break: it reports by callback, and only some calls return a code.
std::string& lastError() {
    static std::string text;
    return text;
}
void onGlfwError(int, const char* description) { lastError() = description; }

/// Keeps drivers and Xlib from printing during its lifetime, so that an error is one line: libGL reports every driver that it cannot
/// load, and no setting silences the last report. With LIBGL_DEBUG set the user wants these reports, and nothing is suppressed.
class SilentDrivers {
public:
    SilentDrivers() : kept_(std::getenv("LIBGL_DEBUG") ? -1 : ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 0)) {
        const int nowhere = kept_ < 0 ? -1 : ::open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (nowhere < 0) return;
        tellLossOfDisplayOn(kept_);
        ::dup2(nowhere, STDERR_FILENO);
        ::close(nowhere);
    }
    ~SilentDrivers() {
        if (kept_ < 0) return;
        ::dup2(kept_, STDERR_FILENO);
        tellLossOfDisplayOn(STDERR_FILENO);
        ::close(kept_);
    }
    SilentDrivers(const SilentDrivers&) = delete;
    SilentDrivers& operator=(const SilentDrivers&) = delete;

private:
    int kept_; ///< standard error, or -1: then nothing is kept from printing
};

GLFWwindow* createWindow(int width, int height, const char* title) {
    const SilentDrivers silent;
    return glfwCreateWindow(width, height, title, nullptr, nullptr);
}

/// Which display it was, where GLFW does not say so (since 3.4).
std::string placeOfDisplay() {
    const char* const given = std::getenv("DISPLAY");
    const std::string name = given ? given : "";
    if (lastError().find(name.empty() ? "DISPLAY" : name) != std::string::npos) return "";
    return name.empty() ? " (DISPLAY is not set)" : " (display " + name + ")";
}

/// Keeps GLFW running while there is a window.
class GlfwLibrary {
public:
    GlfwLibrary() {
        if (users()++ > 0) return;
        lastError().clear();
        glfwSetErrorCallback(onGlfwError);
        endWhenDisplayIsGone();
        const SilentDrivers silent;
        if (glfwInit()) return;
        --users();
        throw Unavailable("GLFW: " + lastError() + placeOfDisplay(), remedyDisplay());
    }
    ~GlfwLibrary() {
        if (--users() == 0) glfwTerminate();
    }
    GlfwLibrary(const GlfwLibrary&) = delete;
    GlfwLibrary& operator=(const GlfwLibrary&) = delete;

private:
    static int& users() {
        static int count = 0;
        return count;
    }
};

class GlfwContext final : public TrackedContext {
public:
    /// `api`: GLFW's constant for GLX or EGL.
    GlfwContext(const WindowOptions& options, int api) {
        lastError().clear();
        glfwDefaultWindowHints();
        glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
        glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE); // the same size in centimetres on a HiDPI screen
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE); // macOS gives a core profile no other way
        glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, options.debug ? GLFW_TRUE : GLFW_FALSE);
        glfwWindowHint(GLFW_CONTEXT_CREATION_API, api);
        window_ = createWindow(options.width, options.height, options.title.c_str());
        if (window_) return;
        const std::string refusal = lastError(), found = describeLegacy(api);
        throw Unavailable("found " + found + " where OpenGL 3.3 core is needed: GLFW: " + refusal,
                          found != kNoOpenGl                                   ? kNewerDriver
                          : refusal.find("GLX extension") != std::string::npos ? kNoGlx
                                                                               : remedyWindowDrivers());
    }
    ~GlfwContext() override {
        letGo();
        glfwDestroyWindow(window_);
    }
    [[nodiscard]] std::string_view backend() const override { return "window"; }
    [[nodiscard]] GLFWwindow* window() const { return window_; }

protected:
    bool bind() override {
        glfwMakeContextCurrent(window_);
        return glfwGetCurrentContext() == window_;
    }
    void unbind() noexcept override { glfwMakeContextCurrent(nullptr); }
    [[nodiscard]] Loader loader() const override { return glfwGetProcAddress; }

private:
    /// What there is instead of 3.3, by asking for a window with a context of any version.
    static std::string describeLegacy(int api) {
        glfwDefaultWindowHints();
        glfwWindowHint(GLFW_CONTEXT_CREATION_API, api);
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
        GLFWwindow* const window = createWindow(1, 1, "");
        if (!window) return kNoOpenGl;
        glfwMakeContextCurrent(window);
        const std::string found = describeGl(glfwGetProcAddress);
        glfwMakeContextCurrent(nullptr);
        glfwDestroyWindow(window);
        return found;
    }

    GlfwLibrary library_; // first, so that GLFW outlives the window
    GLFWwindow* window_ = nullptr;
};

/// By GLX, and where that fails by EGL: X servers of remote desktops (VNC, NX) often lack GLX, and Mesa's EGL needs nothing
/// of theirs. Throws Unavailable with what was wrong with the first.
std::unique_ptr<Context> makeWindow(const WindowOptions& options) {
    requireUsableSettings();
    doWithoutRefusedThreads();
    TrackedContext::releaseCurrent();
    const GlfwLibrary keepsRunning; // from one try to the next
    std::optional<Unavailable> first;
    for (const int api : {GLFW_NATIVE_CONTEXT_API, GLFW_EGL_CONTEXT_API}) {
        try {
            auto context = std::make_unique<GlfwContext>(options, api);
            context->makeCurrent();
            return context;
        } catch (const Unavailable& why) {
            if (!first) first = why;
        }
    }
    throw *first;
}

} // namespace

std::unique_ptr<Context> createWindowContext(const WindowOptions& options) {
    try {
        return makeWindow(options);
    } catch (const Unavailable& why) {
        throw NoWindow(why.what(), why.reason);
    }
}

std::unique_ptr<Context> createHiddenWindowContext(bool debug) {
    // 16 x 16: nothing is drawn into it, but some window systems refuse a window of one pixel.
    return makeWindow({.width = 16, .height = 16, .title = "Shadowlab", .visible = false, .debug = debug});
}

std::optional<std::string> missingDisplay() {
    try {
        const GlfwLibrary library;
        return std::nullopt;
    } catch (const Unavailable& why) {
        const auto isNamed = [](const char* variable) {
            const char* const value = std::getenv(variable);
            return value && *value;
        };
        return isNamed("DISPLAY") || isNamed("WAYLAND_DISPLAY") ? why.reason : "";
    }
}

GLFWwindow* glfwWindow(const Context& context) {
    const auto* glfw = dynamic_cast<const GlfwContext*>(&context);
    return glfw ? glfw->window() : nullptr;
}

} // namespace shadowlab::context
