// Choosing a backend, loading glad, and saying why when nothing works.
// SPDX-License-Identifier: MIT
#include "app/context/context.h"

#include <algorithm>
#include <glad/gl.h>

#include <array>

#include "app/context/backends.h"
#include "app/context/mesa.h"
#include "app/context/software.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/software.h"

namespace shadowlab::context {
namespace {

constexpr int kNeededVersion = GLAD_MAKE_VERSION(3, 3);

struct BackendEntry {
    Backend backend;
    const char* name;
    std::unique_ptr<Context> (*create)(bool debug);
};
/// In the order in which `auto` tries them: EGL needs no display and uses a GPU if there is one, OSMesa carries its own
/// rasteriser, the window needs a display.
constexpr std::array<BackendEntry, 3> kBackends{{
    {Backend::egl, "egl", createEglContext},
    {Backend::osmesa, "osmesa", [](bool) { return createOsmesaContext(); }},
    {Backend::window, "window", createHiddenWindowContext},
}};

std::string glString(GLenum name) {
    const auto* text = glGetString ? reinterpret_cast<const char*>(glGetString(name)) : nullptr;
    return text ? text : "";
}

} // namespace

thread_local TrackedContext* TrackedContext::current_ = nullptr;

void TrackedContext::makeCurrent() {
    if (current_ != this) releaseCurrent();
    if (!bind()) throw Unavailable("the context cannot be made current", remedyDrivers());
    current_ = this;
    const int version = gladLoadGL(loader());
    const bool isNewEnough = version >= kNeededVersion;
    if (isNewEnough && (!isSoftwareDemanded() || isSoftware(glRenderer()))) return;
    const std::string found = describeGl(loader());
    releaseCurrent();
    if (isNewEnough) throw Unavailable("found " + found + " where --software asks for the processor", kNoSoftware);
    throw Unavailable("found " + found + " where OpenGL 3.3 core is needed", kNewerDriver);
}

void TrackedContext::releaseCurrent() noexcept {
    if (current_) current_->letGo();
}

void TrackedContext::letGo() noexcept {
    if (current_ != this) return;
    current_ = nullptr;
    unbind();
}

std::string describeGl(void (*(*load)(const char*))()) {
    using GetString = const GLubyte*(GLAD_API_PTR*)(GLenum);
    const auto getString = reinterpret_cast<GetString>(load("glGetString"));
    const auto* version = getString ? reinterpret_cast<const char*>(getString(GL_VERSION)) : nullptr;
    const auto* renderer = getString ? reinterpret_cast<const char*>(getString(GL_RENDERER)) : nullptr;
    if (!version) return kNoOpenGl;
    return std::string("OpenGL ") + version + (renderer ? std::string(" (") + renderer + ")" : "");
}

std::unique_ptr<Context> createContext(Backend backend, bool debug) {
    requireUsableSettings(); // of all backends, and said once
    std::string reasons;
    std::string remedy;
    for (const BackendEntry& entry : kBackends) {
        if (backend != Backend::automatic && backend != entry.backend) continue;
        try {
            return entry.create(debug);
        } catch (const Unavailable& why) {
            if (backend != Backend::automatic)
                throw Error(ExitStatus::noContext, std::string("no graphics context from ") + entry.name + ": " +
                                                       why.reason + "; " + why.remedy);
            reasons.append(reasons.empty() ? "" : ", ").append(entry.name).append(": ").append(why.reason);
            if (why.remedy == kNewerDriver || why.remedy == kMoreMemory || why.remedy == kNoSoftware) remedy = why.remedy;
        }
    }
    throw Error(ExitStatus::noContext, "no graphics context (" + reasons + "); " + (remedy.empty() ? remedyAll() : remedy));
}

Backend backendFromName(std::string_view name) {
    if (name == "auto") return Backend::automatic;
    for (const BackendEntry& entry : kBackends)
        if (name == entry.name) return entry.backend;
    throw Error(ExitStatus::usage,
                "unknown backend \"" + std::string(name) + "\"; choose one of auto, egl, osmesa, window");
}

std::string glVersion() { return glString(GL_VERSION); }
std::string glRenderer() { return glString(GL_RENDERER); }

int largestSide() {
    GLint texture = 0, viewport[2] = {0, 0};
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    return std::min({texture, viewport[0], viewport[1]});
}

std::vector<BackendReport> probeBackends() {
    Context* const before = TrackedContext::current();
    std::vector<BackendReport> reports;
    for (const BackendEntry& entry : kBackends) {
        BackendReport report;
        report.name = entry.name;
        try {
            const std::unique_ptr<Context> context = entry.create(false);
            report.available = true;
            report.version = glVersion();
            report.renderer = glRenderer();
        } catch (const Unavailable& why) {
            report.reason = why.reason;
            report.remedy = why.remedy;
        }
        reports.push_back(report);
    }
    if (before) before->makeCurrent();
    return reports;
}

} // namespace shadowlab::context
