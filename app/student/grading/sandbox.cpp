// SPDX-License-Identifier: MIT
#include "app/student/grading/sandbox.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/context/assets.h"
#include "app/student/grading/child_program.h"
#include "techniques/foundation/base/error.h"

extern char** environ;

namespace shadowlab::student {

namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

// Libraries, and what finds and configures them; Nix and Guix keep theirs in folders of their own.
constexpr std::array kSystem = {"/usr", "/lib", "/lib32", "/lib64", "/libx32", "/bin", "/sbin", "/opt", "/nix/store", "/gnu/store"};
constexpr std::array kSettings = {"/etc/ld.so.cache", "/etc/ld.so.conf", "/etc/ld.so.conf.d", "/etc/alternatives", "/etc/glvnd",
                                  "/etc/drirc", "/etc/localtime"};
// How Mesa finds a graphics card, and what it talks to.
constexpr std::array kCardFacts = {"/sys/dev/char", "/sys/devices", "/sys/bus/pci", "/sys/class/drm", "/sys/module/nvidia"};
constexpr std::array kCards = {"/dev/dri", "/dev/nvidiactl", "/dev/nvidia0", "/dev/nvidia1", "/dev/nvidia-modeset", "/dev/nvidia-uvm"};

// What is left of the environment: how libraries, OpenGL and this program are to work.
constexpr std::array<std::string_view, 13> kKept = {"LD_LIBRARY_PATH=", "LANG=", "LC_",  "SHADOWLAB_", "MESA_",  "LIBGL_", "GALLIUM_",
                                                    "LP_",              "EGL_",  "__EGL_", "__GLX_",     "__NV_", "DRI_"};

constexpr const char* kInstall = "install it (Debian: apt install bubblewrap)";

fs::path programFile() {
    std::error_code failed;
    fs::path program = fs::read_symlink("/proc/self/exe", failed);
    return failed ? fs::path("/proc/self/exe") : program;
}

fs::path findInPath(const std::string& name) {
    const char* const path = std::getenv("PATH");
    std::string folders = path ? path : "/usr/bin:/bin";
    for (std::size_t at = 0; at <= folders.size();) {
        const std::size_t end = std::min(folders.find(':', at), folders.size());
        const fs::path file = fs::path(folders.substr(at, end - at)) / name;
        if (file.is_absolute() && ::access(file.c_str(), X_OK) == 0) return file;
        at = end + 1;
    }
    return {};
}

void addMount(Words& words, const char* how, const fs::path& place) {
    words.insert(words.end(), {how, place.string(), place.string()});
}

/// /lib is a link to usr/lib where /usr has all.
void addSystem(Words& words) {
    std::error_code failed;
    for (const char* folder : kSystem)
        if (fs::is_symlink(folder, failed))
            words.insert(words.end(), {"--symlink", fs::read_symlink(folder, failed).string(), folder});
        else
            addMount(words, "--ro-bind-try", folder);
    for (const char* file : kSettings)
        addMount(words, "--ro-bind-try", file);
    for (const char* folder : kCardFacts)
        addMount(words, "--ro-bind-try", folder);
}

void addEnvironment(Words& words, const fs::path& scratch) {
    words.emplace_back("--clearenv");
    const auto set = [&](const std::string& name, const std::string& value) {
        words.insert(words.end(), {"--setenv", name, value});
    };
    for (char** entry = environ; *entry; ++entry) {
        const std::string_view text = *entry;
        if (std::ranges::none_of(kKept, [&](std::string_view start) { return text.starts_with(start); })) continue;
        const std::size_t at = text.find('=');
        set(std::string(text.substr(0, at)), std::string(text.substr(at + 1)));
    }
    set("PATH", "/usr/bin:/bin");
    const std::string home = scratch.empty() ? "/" : scratch.string();
    set("HOME", home);
    set("TMPDIR", home);
}

} // namespace

SandboxWanted sandboxFromName(std::string_view name) {
    if (name == "auto") return SandboxWanted::automatic;
    if (name == "on") return SandboxWanted::required;
    if (name == "off") return SandboxWanted::none;
    throw Error(ExitStatus::usage, "--sandbox: '" + std::string(name) + "' is no way to run; write auto, on or off");
}

Sandbox::Sandbox(SandboxWanted wanted, fs::path program) : program_(program.empty() ? programFile() : std::move(program)) {
    if (wanted == SandboxWanted::none) return;
    bwrap_ = findInPath("bwrap");
    if (bwrap_.empty())
        whyNot_ = std::string("the program bwrap is not here; ") + kInstall;
    else if (const std::string why = refusal(); !why.empty()) {
        bwrap_.clear();
        whyNot_ = "bwrap cannot make one here (" + why + "); allow user namespaces, or grade in a virtual machine";
    }
    if (!isOn() && wanted == SandboxWanted::required)
        throw Error(ExitStatus::badInput, "--sandbox on: " + whyNot_ + ", or write --sandbox auto");
}

std::string Sandbox::refusal() const {
    constexpr ChildLimits kShort{std::chrono::seconds(10)};
    try {
        const ChildEnd end = runChild({"--version"}, kShort, *this, {});
        return end.how == ChildEnd::How::finished ? "" : end.message;
    } catch (const Error& why) {
        const std::string text = why.what();
        return text.substr(0, text.find("; "));
    }
}

Words Sandbox::around(const Words& words, const SandboxRoom& room) const {
    Words all;
    if (isOn()) {
        all = {bwrap_.string(),   "--unshare-user", "--unshare-ipc",        "--unshare-pid",   "--unshare-net",
               "--unshare-uts",   "--hostname",     "sandbox",              "--unshare-cgroup-try", "--die-with-parent",
               "--new-session",   "--cap-drop",     "ALL"};
        addEnvironment(all, room.scratch);
        addSystem(all);
        all.insert(all.end(), {"--proc", "/proc", "--dev", "/dev"});
        for (const char* card : kCards)
            addMount(all, "--dev-bind-try", card);
        addMount(all, "--ro-bind", program_);
        addMount(all, "--ro-bind", fs::absolute(context::assetsRoot()).lexically_normal());
        for (const fs::path& place : room.readable)
            addMount(all, "--ro-bind", fs::absolute(place).lexically_normal());
        if (!room.scratch.empty()) addMount(all, "--bind", room.scratch);
        // The root and /dev are in memory that no process is charged for.
        all.insert(all.end(), {"--remount-ro", "/dev", "--remount-ro", "/", "--chdir", room.scratch.empty() ? "/" : room.scratch.string(),
                               "--"});
    }
    all.push_back(program_.string());
    all.insert(all.end(), words.begin(), words.end());
    return all;
}

} // namespace shadowlab::student
