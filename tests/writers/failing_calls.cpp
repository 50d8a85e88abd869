// A library to be loaded before all others (LD_PRELOAD): it counts the calls by which a program changes one folder, and
// lets one of them fail, do half of its work, or be the last thing that the program does.
//
//   FAULT_FOLDER  the folder; calls on anything else pass
//   FAULT_LOG     a file that gets the name of each counted call, one in a line
//   FAULT_AT      which of them: 1 is the first
//   FAULT_HOW     an error number; `short`: a write writes half; `kill`: SIGKILL comes before the call, `half-kill`: in
//                 the middle of a write; `full`: from here on the disk is full, calls that need no space work
// SPDX-License-Identifier: MIT
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

namespace {

struct Plan {
    std::string folder;
    std::string_view how;
    int at = 0;
    int log = -1;
    bool ready = false;
};

/// Never destroyed: calls come until the very end of the process.
Plan& plan() {
    static Plan* const plan = new Plan;
    return *plan;
}

__attribute__((constructor)) void begin() {
    const auto text = [](const char* name) {
        const char* value = std::getenv(name);
        return std::string(value ? value : "");
    };
    plan().folder = text("FAULT_FOLDER");
    static const std::string how = text("FAULT_HOW");
    plan().how = how;
    plan().at = std::atoi(text("FAULT_AT").c_str());
    if (const std::string log = text("FAULT_LOG"); !log.empty())
        plan().log = static_cast<int>(
            ::syscall(SYS_openat, AT_FDCWD, log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
    ::unsetenv("LD_PRELOAD"); // programs that this one starts are none of our business
    plan().ready = true;
}

bool isInside(const std::string& path) {
    const std::string& folder = plan().folder;
    return plan().ready && !folder.empty() && path.starts_with(folder) &&
           (path.size() == folder.size() || path[folder.size()] == '/');
}

std::string pathOf(int descriptor) {
    std::array<char, PATH_MAX> path{};
    const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
    const ssize_t length = ::readlink(link.c_str(), path.data(), path.size());
    return length > 0 ? std::string(path.data(), static_cast<std::size_t>(length)) : "";
}

bool isInside(int folder, const char* name) {
    std::string path = name;
    if (!path.starts_with('/')) {
        std::array<char, PATH_MAX> here{};
        path =
            (folder == AT_FDCWD ? std::string(::getcwd(here.data(), here.size()) ? here.data() : "") : pathOf(folder)) +
            "/" + path;
    }
    return isInside(path);
}

enum class Fate { works, fails, half, killedInTheMiddle };

/// Counts a call, and says what is to become of it; where it fails, errno is set.
Fate fateOf(const char* call, bool needsSpace) {
    static std::atomic<int> counter{0};
    const int number = ++counter;
    if (plan().log >= 0) {
        const std::string line = std::string(call) + "\n";
        if (::syscall(SYS_write, plan().log, line.data(), line.size()) < 0) std::abort();
    }
    const bool isFull = plan().how == "full" && plan().at > 0 && number >= plan().at;
    if (isFull && needsSpace) {
        errno = ENOSPC;
        return Fate::fails;
    }
    if (number != plan().at || isFull) return Fate::works;
    if (plan().how == "kill") ::raise(SIGKILL);
    if (plan().how == "half-kill") return Fate::killedInTheMiddle;
    if (plan().how == "short") return Fate::half;
    errno = std::atoi(plan().how.data());
    return Fate::fails;
}

template <typename Function>
Function original(const char* name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

int opened(int folder, const char* name, int flags, mode_t mode) {
    if (isInside(folder, name) &&
        fateOf((flags & O_CREAT) ? "open-new" : "open", (flags & O_CREAT) != 0) == Fate::fails)
        return -1;
    return static_cast<int>(::syscall(SYS_openat, folder, name, flags, mode));
}

mode_t modeOf(int flags, va_list arguments) { return (flags & (O_CREAT | O_TMPFILE)) ? va_arg(arguments, mode_t) : 0; }

} // namespace

// --- the calls themselves, under the names that programs and the library of C++ know

extern "C" {

int open(const char* name, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = modeOf(flags, arguments);
    va_end(arguments);
    return opened(AT_FDCWD, name, flags, mode);
}

int open64(const char* name, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = modeOf(flags, arguments);
    va_end(arguments);
    return opened(AT_FDCWD, name, flags, mode);
}

int openat(int folder, const char* name, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = modeOf(flags, arguments);
    va_end(arguments);
    return opened(folder, name, flags, mode);
}

FILE* fopen(const char* name, const char* mode) {
    static const auto next = original<FILE* (*)(const char*, const char*)>("fopen");
    const bool writes = std::strpbrk(mode, "wa+") != nullptr;
    if (writes && isInside(AT_FDCWD, name) && fateOf("open-new", true) == Fate::fails) return nullptr;
    return next(name, mode);
}

ssize_t write(int descriptor, const void* bytes, std::size_t count) {
    if (isInside(pathOf(descriptor))) {
        const Fate fate = fateOf("write", true);
        if (fate == Fate::fails) return -1;
        if (fate != Fate::works) {
            const ssize_t done = ::syscall(SYS_write, descriptor, bytes, (count + 1) / 2);
            if (fate == Fate::killedInTheMiddle) ::raise(SIGKILL);
            return done;
        }
    }
    return ::syscall(SYS_write, descriptor, bytes, count);
}

int fsync(int descriptor) {
    struct stat status {};
    const bool isFolder = ::fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode);
    if (isInside(pathOf(descriptor)) && fateOf(isFolder ? "fsync-folder" : "fsync", true) == Fate::fails) return -1;
    return static_cast<int>(::syscall(SYS_fsync, descriptor));
}

int close(int descriptor) {
    const bool isOurs = isInside(pathOf(descriptor));
    const Fate fate = isOurs ? fateOf("close", true) : Fate::works;
    const int failure = errno;
    const int result = static_cast<int>(::syscall(SYS_close, descriptor)); // a close that fails has closed all the same
    if (fate != Fate::fails) return result;
    errno = failure;
    return -1;
}

int rename(const char* from, const char* to) {
    if (isInside(AT_FDCWD, to) && fateOf("rename", true) == Fate::fails) return -1;
    return static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

int unlink(const char* name) {
    if (isInside(AT_FDCWD, name) && fateOf("unlink", false) == Fate::fails) return -1;
    return static_cast<int>(::syscall(SYS_unlinkat, AT_FDCWD, name, 0));
}

int unlinkat(int folder, const char* name, int flags) {
    if (isInside(folder, name) && fateOf("unlink", false) == Fate::fails) return -1;
    return static_cast<int>(::syscall(SYS_unlinkat, folder, name, flags));
}

int mkdir(const char* name, mode_t mode) {
    if (isInside(AT_FDCWD, name) && fateOf("mkdir", true) == Fate::fails) return -1;
    return static_cast<int>(::syscall(SYS_mkdirat, AT_FDCWD, name, mode));
}

int fchmod(int descriptor, mode_t mode) {
    if (isInside(pathOf(descriptor)) && fateOf("fchmod", false) == Fate::fails) return -1;
    return static_cast<int>(::syscall(SYS_fchmod, descriptor, mode));
}

int flock(int descriptor, int operation) {
    if (isInside(pathOf(descriptor)) && fateOf("flock", false) == Fate::fails) return -1;
    return static_cast<int>(::syscall(SYS_flock, descriptor, operation));
}

} // extern "C"
