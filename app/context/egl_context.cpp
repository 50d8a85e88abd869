// EGL without a surface: OpenGL on a server, on a GPU if the machine has one, else on Mesa's software rasteriser.
//
// Three ways to a display are tried: Mesa's surfaceless platform, then every device EGL can list (the way of other
// drivers), then the default display. EGL is loaded at run time; its headers serve for types and constants only.
// SPDX-License-Identifier: MIT
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

#include "app/context/backends.h"
#include "app/context/library.h"
#include "app/context/mesa.h"
#include "app/context/software.h"

namespace shadowlab::context {
namespace {

struct Egl {
    Library library{"libEGL.so.1", "libEGL.so"};
    decltype(&eglGetProcAddress) getProcAddress = nullptr;
    decltype(&eglQueryString) queryString = nullptr;
    decltype(&eglGetDisplay) getDisplay = nullptr;
    decltype(&eglInitialize) initialize = nullptr;
    decltype(&eglBindAPI) bindApi = nullptr;
    decltype(&eglChooseConfig) chooseConfig = nullptr;
    decltype(&eglCreateContext) createContext = nullptr;
    decltype(&eglDestroyContext) destroyContext = nullptr;
    decltype(&eglCreatePbufferSurface) createPbuffer = nullptr;
    decltype(&eglDestroySurface) destroySurface = nullptr;
    decltype(&eglMakeCurrent) makeCurrent = nullptr;
    decltype(&eglGetError) getError = nullptr;

    bool complete =
        library.find(getProcAddress, "eglGetProcAddress") && library.find(queryString, "eglQueryString") &&
        library.find(getDisplay, "eglGetDisplay") && library.find(initialize, "eglInitialize") &&
        library.find(bindApi, "eglBindAPI") && library.find(chooseConfig, "eglChooseConfig") &&
        library.find(createContext, "eglCreateContext") && library.find(destroyContext, "eglDestroyContext") &&
        library.find(createPbuffer, "eglCreatePbufferSurface") && library.find(destroySurface, "eglDestroySurface") &&
        library.find(makeCurrent, "eglMakeCurrent") && library.find(getError, "eglGetError");

    template <typename Function>
    Function extension(const char* name) const {
        return reinterpret_cast<Function>(getProcAddress(name));
    }
};
const Egl& egl() {
    static const Egl functions;
    return functions;
}

/// Extension lists are words separated by blanks; a word may be the beginning of another.
bool lists(const char* extensions, std::string_view wanted) {
    return extensions &&
           (' ' + std::string(extensions) + ' ').find(' ' + std::string(wanted) + ' ') != std::string::npos;
}

std::string errorText() {
    switch (const EGLint code = egl().getError()) {
    case EGL_NOT_INITIALIZED: return "no driver can be loaded (0x3001)";
    case EGL_BAD_MATCH: return "no such OpenGL version (0x3009)";
    default: {
        std::array<char, 16> text{};
        std::snprintf(text.data(), text.size(), "error 0x%04x", static_cast<unsigned>(code));
        return text.data();
    }
    }
}

struct Candidate {
    const char* name;
    std::function<EGLDisplay()> open; ///< called in turn, so that nothing is started that is not needed
};

bool isSoftwareDevice(EGLDeviceEXT device) {
    const auto text = egl().extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    return text && lists(text(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
}

std::vector<Candidate> candidates() {
    const char* const extensions = egl().queryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const auto platformDisplay = egl().extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    std::vector<Candidate> list;
    if (platformDisplay && lists(extensions, "EGL_MESA_platform_surfaceless"))
        list.push_back({"surfaceless",
                        [=] { return platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr); }});

    const auto queryDevices = egl().extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    const bool devices = lists(extensions, "EGL_EXT_device_base") || lists(extensions, "EGL_EXT_device_enumeration");
    if (platformDisplay && queryDevices && devices && lists(extensions, "EGL_EXT_platform_device")) {
        std::array<EGLDeviceEXT, 16> found{}; // more devices than any one machine has
        EGLint count = 0;
        if (!queryDevices(static_cast<EGLint>(found.size()), found.data(), &count)) count = 0;
        for (EGLint i = 0; i < count; ++i) {
            const EGLDeviceEXT device = found[static_cast<std::size_t>(i)];
            if (isSoftwareDemanded() && !isSoftwareDevice(device)) continue;
            list.push_back({"device", [platformDisplay, device] {
                                return platformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
                            }});
        }
    }
    list.push_back({"default display", [] { return egl().getDisplay(EGL_DEFAULT_DISPLAY); }});
    return list;
}

class EglContext final : public TrackedContext {
public:
    EglContext(EGLDisplay display, bool debug) : display_(display) {
        // Displays are never terminated: EGL hands out the same one again, and another context may still use it.
        EGLint major = 0, minor = 0;
        if (display_ == EGL_NO_DISPLAY) throw Unavailable("no display", remedyEglDrivers());
        if (!egl().initialize(display_, &major, &minor)) throw Unavailable(errorText(), remedyDrivers());
        if (!egl().bindApi(EGL_OPENGL_API)) throw Unavailable("only OpenGL ES", remedyDrivers());
        const char* const extensions = egl().queryString(display_, EGL_EXTENSIONS);
        chooseConfig();
        // Forward-compatible: what is deprecated is refused here as it is by drivers that have no other core profile.
        constexpr EGLint forward = EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE_BIT_KHR;
        const std::array<EGLint, 9> attributes{EGL_CONTEXT_MAJOR_VERSION_KHR,
                                               3,
                                               EGL_CONTEXT_MINOR_VERSION_KHR,
                                               3,
                                               EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                                               EGL_CONTEXT_FLAGS_KHR,
                                               debug ? forward | EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR : forward,
                                               EGL_NONE};
        context_ = egl().createContext(display_, config_, EGL_NO_CONTEXT, attributes.data());
        if (context_ == EGL_NO_CONTEXT) {
            const std::string refusal = errorText();
            throw Unavailable("found " + describeLegacy() + " where OpenGL 3.3 core is needed: " + refusal,
                              kNewerDriver);
        }
        if (!lists(extensions, "EGL_KHR_surfaceless_context")) {
            constexpr std::array<EGLint, 5> onePixel{EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
            surface_ = egl().createPbuffer(display_, config_, onePixel.data());
        }
    }
    ~EglContext() override {
        letGo();
        if (surface_ != EGL_NO_SURFACE) egl().destroySurface(display_, surface_);
        if (context_ != EGL_NO_CONTEXT) egl().destroyContext(display_, context_);
    }
    [[nodiscard]] std::string_view backend() const override { return "egl"; }

protected:
    bool bind() override {
        egl().bindApi(EGL_OPENGL_API); // another library in the process may have asked for OpenGL ES
        return egl().makeCurrent(display_, surface_, surface_, context_) == EGL_TRUE;
    }
    void unbind() noexcept override { egl().makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }
    [[nodiscard]] Loader loader() const override { return egl().getProcAddress; }

private:
    void chooseConfig() {
        // EGL_SURFACE_TYPE has to be named: its default asks for windows, and a surfaceless display has none.
        for (const EGLint surfaces : {EGL_PBUFFER_BIT, EGL_DONT_CARE}) {
            const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, surfaces, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                               EGL_NONE};
            EGLint count = 0;
            if (egl().chooseConfig(display_, wanted.data(), &config_, 1, &count) && count > 0) return;
        }
        throw Unavailable("no configuration for OpenGL", remedyDrivers());
    }
    /// What there is instead of 3.3, by asking for a context of any version.
    std::string describeLegacy() const {
        const EGLContext context = egl().createContext(display_, config_, EGL_NO_CONTEXT, nullptr);
        if (context == EGL_NO_CONTEXT) return kNoOpenGl;
        std::string found = kNoOpenGl;
        if (egl().makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
            found = describeGl(egl().getProcAddress);
        egl().makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl().destroyContext(display_, context);
        return found;
    }

    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLConfig config_ = nullptr;
    EGLContext context_ = EGL_NO_CONTEXT;
    EGLSurface surface_ = EGL_NO_SURFACE;
};

} // namespace

std::unique_ptr<Context> createEglContext(bool debug) {
    // Mesa prints its own remarks about every attempt that fails; ours stay one line. The user's own setting wins.
    ::setenv("EGL_LOG_LEVEL", "fatal", 0);
    if (const std::string& fault = egl().library.fault(); !fault.empty()) throw Unavailable(fault, kMoreMemory);
    if (!egl().library.loaded()) throw Unavailable("libEGL.so.1 is missing", remedyEgl());
    if (!egl().complete) throw Unavailable("libEGL lacks functions of EGL 1.4", remedyEgl());
    requireUsableSettings();
    doWithoutRefusedThreads();
    TrackedContext::releaseCurrent();
    std::string reasons, lastReason, remedy;
    for (const Candidate& candidate : candidates()) {
        try {
            auto context = std::make_unique<EglContext>(candidate.open(), debug);
            context->makeCurrent();
            return context;
        } catch (const Unavailable& why) {
            if (reasons.empty()) remedy = why.remedy; // of the first way, which is the one most machines should offer
            if (why.reason == lastReason) continue;
            reasons.append(reasons.empty() ? "" : ", ").append(candidate.name).append(": ").append(why.reason);
            lastReason = why.reason;
        }
    }
    throw Unavailable(reasons, remedy);
}

} // namespace shadowlab::context
