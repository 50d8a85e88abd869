// OSMesa: Mesa's software rasteriser drawing into memory that we own. It needs no display, no GPU and no driver files.
// Mesa ended it in 25.1: Debian 13 is the last one that has it, and EGL's surfaceless platform does the same work there and later.
// So it is loaded at run time; the few declarations needed are repeated here from GL/osmesa.h, which cannot be included beside
// glad.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

#include "app/context/backends.h"
#include "app/context/library.h"
#include "app/context/mesa.h"

namespace shadowlab::context {
namespace {

using OsContext = struct osmesa_context*;
enum : int { kFormat = 0x22, kProfile = 0x33, kCoreProfile = 0x34, kMajorVersion = 0x36, kMinorVersion = 0x37 };
constexpr unsigned kRgba = 0x1908, kUnsignedByte = 0x1401; // GL_RGBA, GL_UNSIGNED_BYTE

struct OsMesa {
    // .so.8 is Debian's, .so.6 an alias that some distributions ship alone, .so comes with the development package.
    Library library{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
    OsContext (*createAttribs)(const int* attributes, OsContext share) = nullptr;
    OsContext (*createLegacy)(unsigned format, OsContext share) = nullptr;
    void (*destroy)(OsContext) = nullptr;
    unsigned char (*makeCurrent)(OsContext, void* buffer, unsigned type, int width, int height) = nullptr;
    void (*(*getProcAddress)(const char*))() = nullptr;

    bool complete = library.find(createAttribs, "OSMesaCreateContextAttribs") &&
                    library.find(createLegacy, "OSMesaCreateContext") &&
                    library.find(destroy, "OSMesaDestroyContext") && library.find(makeCurrent, "OSMesaMakeCurrent") &&
                    library.find(getProcAddress, "OSMesaGetProcAddress");
};
const OsMesa& osmesa() {
    static const OsMesa functions;
    return functions;
}

/// One pixel: OSMesa insists on a buffer, and we draw only into our own framebuffers.
using Buffer = std::array<unsigned char, 4>;

/// What this machine has instead of 3.3, by asking for a context of any version.
std::string describeLegacy() {
    const OsContext context = osmesa().createLegacy(kRgba, nullptr);
    if (!context) return kNoOpenGl;
    Buffer pixel{};
    std::string found = kNoOpenGl;
    if (osmesa().makeCurrent(context, pixel.data(), kUnsignedByte, 1, 1)) found = describeGl(osmesa().getProcAddress);
    osmesa().makeCurrent(nullptr, nullptr, 0, 0, 0);
    osmesa().destroy(context);
    return found;
}

class OsMesaContext final : public TrackedContext {
public:
    OsMesaContext() {
        constexpr std::array<int, 9> attributes{
            kFormat, static_cast<int>(kRgba), kProfile, kCoreProfile, kMajorVersion, 3, kMinorVersion, 3, 0};
        context_ = osmesa().createAttribs(attributes.data(), nullptr);
        if (!context_)
            throw Unavailable("found " + describeLegacy() + " where OpenGL 3.3 core is needed", kNewerDriver);
    }
    ~OsMesaContext() override {
        letGo();
        osmesa().destroy(context_);
    }
    [[nodiscard]] std::string_view backend() const override { return "osmesa"; }

protected:
    bool bind() override { return osmesa().makeCurrent(context_, pixel_.data(), kUnsignedByte, 1, 1) != 0; }
    void unbind() noexcept override { osmesa().makeCurrent(nullptr, nullptr, 0, 0, 0); }
    [[nodiscard]] Loader loader() const override { return osmesa().getProcAddress; }

private:
    OsContext context_ = nullptr;
    Buffer pixel_{};
};

/// Settings under which OSMesa ends the program instead of saying that it has no context.
void requireSurvivableSettings() {
    const auto setting = [](const char* name) {
        const char* value = std::getenv(name);
        return std::string_view(value ? value : "");
    };
    const std::string_view driver = setting("GALLIUM_DRIVER");
    if (!driver.empty() && driver != "llvmpipe" &&
        driver != "softpipe") // it makes none of another name, and then uses it
        throw Unavailable("GALLIUM_DRIVER asks for a driver that OSMesa does not have",
                          "unset GALLIUM_DRIVER, or write llvmpipe or softpipe");
    const std::string_view shaders = setting("MESA_GLSL_VERSION_OVERRIDE");
    if (!shaders.empty() && shaders < "330" && setting("MESA_GL_VERSION_OVERRIDE").empty())
        throw Unavailable("MESA_GLSL_VERSION_OVERRIDE asks for shaders older than those of OpenGL 3.3",
                          "unset MESA_GLSL_VERSION_OVERRIDE");
    constexpr std::array<std::string_view, 4> kNo{"0", "n", "no", "false"};
    if (std::ranges::find(kNo, setting("DRAW_USE_LLVM")) != kNo.end())
        throw Unavailable("DRAW_USE_LLVM takes away what OSMesa counts on", "unset DRAW_USE_LLVM");
}

} // namespace

bool isOsmesaHere() { return osmesa().library.loaded(); }

std::unique_ptr<Context> createOsmesaContext() {
    if (const std::string& fault = osmesa().library.fault(); !fault.empty()) throw Unavailable(fault, kMoreMemory);
    if (!osmesa().library.loaded()) throw Unavailable("libOSMesa.so.8 is missing", remedyOsmesa());
    if (!osmesa().complete)
        throw Unavailable("libOSMesa is older than Mesa 11.2 and cannot do core profiles", remedyOsmesa());
    requireSurvivableSettings();
    requireUsableSettings();
    doWithoutRefusedThreads();
    TrackedContext::releaseCurrent();
    auto context = std::make_unique<OsMesaContext>();
    context->makeCurrent();
    return context;
}

} // namespace shadowlab::context
