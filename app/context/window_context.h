// A GLFW window with an OpenGL 3.3 core context: hidden for headless work, visible for the program's own window.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "app/context/context.h"
#include "techniques/foundation/base/error.h"

struct GLFWwindow;

namespace shadowlab::context {

struct WindowOptions {
    int width = 1280, height = 720; ///< screen coordinates, not pixels
    std::string title = "Shadowlab";
    bool visible = true;
    bool debug = false;
};

/// No window can be opened: `reason` alone; what() adds what to do about it.
class NoWindow : public Error {
public:
    NoWindow(const std::string& what, const std::string& reasonIn)
        : Error(ExitStatus::noContext, what), reason(reasonIn) {}
    std::string reason;
};

/// The context is current and glad is loaded. The last window to go shuts GLFW down. Throws NoWindow.
std::unique_ptr<Context> createWindowContext(const WindowOptions& options);

/// Why no window can be opened here at all; empty where no display is named, none where one can. Asks the window system itself: a
/// variable that is set proves nothing.
std::optional<std::string> missingDisplay();

/// The window of such a context, owned by it; null for the other backends.
GLFWwindow* glfwWindow(const Context& context);

} // namespace shadowlab::context
