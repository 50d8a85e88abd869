// What the three backends have in common, and how each is made. Only for the files of this folder; users of contexts
// include context.h (and window_context.h for the visible window).
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>

#include "app/context/context.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::context {

/// A backend that does not work here: what was found, and what the user can do.
class Unavailable : public Error {
public:
    Unavailable(const std::string& reasonIn, const std::string& remedyIn)
        : Error(ExitStatus::noContext, "no graphics context: " + reasonIn + "; " + remedyIn), reason(reasonIn),
          remedy(remedyIn) {}
    std::string reason, remedy;
};

/// What to do about each, on this system: packages as Debian names them (packages.h), and other backends that are here.
/// libegl1 does not pull in the drivers (libgl1-mesa-dri) by itself.
std::string remedyEgl();
std::string remedyOsmesa();
std::string remedyDrivers();
std::string remedyEglDrivers();
std::string remedyWindowDrivers();
std::string remedyDisplay();
std::string remedyAll(); ///< where no backend works
inline constexpr const char* kMoreMemory =
    "allow the program more memory (ulimit -v), or install the library's package again";
inline constexpr const char* kNewerDriver = "take a newer driver, and unset MESA_GL_VERSION_OVERRIDE and "
                                            "MESA_GLSL_VERSION_OVERRIDE if they are set";
/// A remote X server may have neither GLX nor visuals of the depth that EGL needs. No package of this system changes that.
inline constexpr const char* kNoGlx = "use another X server, or take --backend egl, which needs none";
inline constexpr const char* kNoSoftware = "unset GALLIUM_DRIVER and MESA_LOADER_DRIVER_OVERRIDE if they are set, or "
                                           "leave --software out";

/// Keeps track of which context is current. EGL, GLX and OSMesa each keep this state
/// for themselves, so the old context is released through its own interface before the next is bound.
class TrackedContext : public Context {
public:
    /// Binds, loads glad and throws Unavailable unless the context is at least 3.3, and drawn as was asked for (software.h).
    void makeCurrent() final;

    /// Leaves no context current. Every factory below starts with this.
    static void releaseCurrent() noexcept;
    [[nodiscard]] static Context* current() { return current_; }

protected:
    using GlFunction = void (*)();
    using Loader = GlFunction (*)(const char* name);

    virtual bool bind() = 0; ///< false when the window system refuses
    virtual void unbind() noexcept = 0;
    [[nodiscard]] virtual Loader loader() const = 0;

    /// To be called first in every destructor of a backend (a base class destructor comes too late for unbind).
    void letGo() noexcept;

private:
    static thread_local TrackedContext* current_;
};

/// Each throws Unavailable. The result is current; the context that was current before is not, even after a failure.
std::unique_ptr<Context> createEglContext(bool debug);
std::unique_ptr<Context> createOsmesaContext();
std::unique_ptr<Context> createHiddenWindowContext(bool debug);

/// Whether this system has the library of OSMesa.
bool isOsmesaHere();

/// The words for a backend of which nothing was found.
inline constexpr const char* kNoOpenGl = "no OpenGL";

/// "OpenGL 2.1 Mesa 22.3.6 (llvmpipe)" from a context's own glGetString, for messages before glad is loaded.
std::string describeGl(void (*(*load)(const char*))());

} // namespace shadowlab::context
