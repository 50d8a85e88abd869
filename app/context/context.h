// One interface, three ways to an OpenGL 3.3 core context: EGL without a surface, OSMesa, and a GLFW window.
// All rendering goes to the project's own framebuffers, so a context needs no picture of its own, and one scene gives
// the same bytes on all three with the same Mesa. EGL and OSMesa are loaded at run time: the program starts without.
// Contexts belong to the main thread.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace shadowlab::context {

enum class Backend { automatic, egl, osmesa, window };

class Context {
public:
    Context() = default;
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    /// Makes this the context that GL calls go to. Reloads glad, because the entry points of two backends differ.
    virtual void makeCurrent() = 0;
    [[nodiscard]] virtual std::string_view backend() const = 0; ///< "egl", "osmesa" or "window"
};

/// The context is current and glad is loaded. `debug` asks for a debug context where the backend knows the difference.
/// Throws Error (noContext) saying what was found and what to install.
std::unique_ptr<Context> createContext(Backend backend, bool debug = false);

/// "auto", "egl", "osmesa" or "window". Throws Error (usage) for anything else.
Backend backendFromName(std::string_view name);

/// GL_VERSION and GL_RENDERER of the current context.
std::string glVersion();
std::string glRenderer();
/// Pixels on a side of the largest picture that the current context draws.
int largestSide();

/// One line of `list backends`. The context that was current before is current again afterwards.
struct BackendReport {
    std::string name;
    bool available = false;
    std::string version, renderer; ///< when available
    std::string reason, remedy;      ///< when not
};
std::vector<BackendReport> probeBackends();

} // namespace shadowlab::context
