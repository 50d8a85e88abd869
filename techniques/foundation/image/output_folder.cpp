// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/output_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <string>
#include <thread>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_error.h"

namespace shadowlab::image {

namespace {

namespace fs = std::filesystem;

fs::path aboveOf(const fs::path& folder) { return folder.has_parent_path() ? folder.parent_path() : fs::path("."); }

/// A descriptor of the folder with our lock on it, or -1 if another process holds the lock. On a file system without locks
/// the lock counts as ours.
int lockedFolder(const fs::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0) return -1;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return descriptor;
    ::close(descriptor);
    return -1;
}

} // namespace

void makeFolders(const fs::path& folder) {
    std::error_code failed;
    do {
        fs::create_directories(folder, failed);
    } while (failed.value() == EINTR);
    if (failed) throw Error(ExitStatus::cannotWrite, outputErrorText(folder, failed.value(), false));
}

FolderLock::FolderLock(const fs::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    constexpr int kTries = 200;
    constexpr std::chrono::milliseconds kPause(10);
    for (int i = 0; descriptor_ >= 0 && i < kTries; ++i) {
        if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || (errno != EWOULDBLOCK && errno != EINTR)) return;
        std::this_thread::sleep_for(kPause);
    }
}

FolderLock::~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

OutputFolder::OutputFolder(const fs::path& target) : target_(target) {
    const std::string prefix = "." + target.filename().string() + ".tmp.";
    std::error_code ignored;
    for (fs::directory_iterator entry(aboveOf(target), ignored), end; !ignored && entry != end;
         entry.increment(ignored)) {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with(prefix) || name.find_first_not_of("0123456789.", prefix.size()) != std::string::npos)
            continue; // no name of ours
        const int stray = lockedFolder(entry->path());
        std::error_code stays;
        if (stray >= 0) fs::remove_all(entry->path(), stays);
        if (stray >= 0) ::close(stray);
    }
    for (int number = 0; temporary_.empty(); ++number) {
        const fs::path name = aboveOf(target) / (prefix + std::to_string(::getpid()) + "." + std::to_string(number));
        if (::mkdir(name.c_str(), 0777) == 0)
            temporary_ = name;
        else if (errno != EEXIST && errno != EINTR)
            fail(errno);
    }
    listed_.list(temporary_);
    lock_ = lockedFolder(temporary_); // best effort: without it, another run that makes the same folder may disturb
}

OutputFolder::~OutputFolder() {
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
    if (ignored)
        fs::remove(temporary_, ignored); // fails where the umask forbids reading it; then it is empty
    if (lock_ >= 0) ::close(lock_);
}

void OutputFolder::fail(int errorNumber) const {
    throw Error(ExitStatus::cannotWrite, outputErrorText(target_, errorNumber, false));
}

void OutputFolder::commit() {
    while (::rename(temporary_.c_str(), target_.c_str()) != 0)
        if (errno != EINTR) fail(errno);
    listed_.strike();
    temporary_.clear();
}

void writeFolder(const fs::path& folder, const std::function<void(const fs::path&)>& fill) {
    std::error_code failed;
    const fs::path absolute = fs::absolute(folder, failed);
    if (failed) throw Error(ExitStatus::cannotWrite, outputErrorText(folder, failed.value(), false));
    const fs::path target = absolute.lexically_normal();
    const fs::path made = target.has_filename() ? target : target.parent_path();
    if (fs::exists(fs::symlink_status(made, failed)))
        throw Error(ExitStatus::cannotWrite,
                    folder.string() + ": there is something of that name already; choose another folder with -o");
    OutputFolder output(made);
    try {
        fill(output.path());
    } catch (const Error& fault) {
        // Of a place that is gone when the message is read: named is the one that was asked for.
        std::string message = fault.what();
        const std::string temporary = output.path().string();
        if (const std::size_t at = message.find(temporary); at != std::string::npos)
            message.replace(at, temporary.size(), made.string());
        throw Error(fault.status(), message);
    }
    output.commit();
}

} // namespace shadowlab::image
