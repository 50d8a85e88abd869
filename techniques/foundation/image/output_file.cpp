// Whole-or-nothing output: temporary, checked writes, fsync, checked close, rename.
//
// A run that is killed outright cannot clean up. Its temporary is removed by the next run that writes the same name: every
// writer holds a lock (flock) on its temporary, so an unlocked one has no owner any more. The process number in the name is
// information for the user only; numbers are reused, and containers have their own.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/output_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <mutex>
#include <set>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_error.h"

namespace shadowlab::image {
namespace {

namespace fs = std::filesystem;

/// `.NAME.tmp.`; a long name is cut, for the temporary's own name must also fit into 255 bytes with its numbers.
std::string temporaryPrefix(const fs::path& target) {
    return std::string(".").append(target.filename().string(), 0, 200).append(".tmp.");
}

fs::path folderOf(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// Repeats a system call while a signal interrupts it (EINTR). On network file systems this happens even to calls that
/// never block on a disk. Returns the result of the last call.
template <typename Call>
int repeated(const Call& call) {
    int result = 0;
    do {
        result = call();
    } while (result != 0 && errno == EINTR);
    return result;
}

/// The open descriptor that a name such as /dev/stdout stands for, or -1. Opening it again would start at offset 0 and
/// overwrite what `>> log` meant to keep.
int inheritedDescriptor(const fs::path& path) {
    const std::string name = path.string();
    if (name == "/dev/stdout") return STDOUT_FILENO;
    if (name == "/dev/stderr") return STDERR_FILENO;
    for (const std::string_view prefix : {"/dev/fd/", "/proc/self/fd/"}) {
        const std::string number = name.starts_with(prefix) ? name.substr(prefix.size()) : "";
        if (number.empty() || number.size() > 6 || number.find_first_not_of("0123456789") != std::string::npos)
            continue;
        return std::atoi(number.c_str());
    }
    return -1;
}

/// Removes temporaries of this target that no living run holds.
void sweepStrays(const fs::path& target) {
    const std::string prefix = temporaryPrefix(target);
    std::error_code ignored;
    for (fs::directory_iterator entry(folderOf(target), ignored), end; !ignored && entry != end;
         entry.increment(ignored)) {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with(prefix) || name.find_first_not_of("0123456789.", prefix.size()) != std::string::npos)
            continue; // not a name made by createTemporary()
        const int descriptor = ::open(entry->path().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (descriptor < 0) continue;
        struct stat status {};
        if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
            ::unlink(entry->path().c_str());
        ::close(descriptor);
    }
}

struct Inputs {
    std::mutex mutex;         // scenes are also read in the background
    std::set<fs::path> files; // canonical paths, not inode numbers, which are reused
};
Inputs& inputs() {
    static Inputs all;
    return all;
}

} // namespace

OutputFile::OutputFile(const fs::path& path) : shown_(path), target_(path) {
    if (path.empty()) throw Error(ExitStatus::cannotWrite, "the output has no name; give a file name after -o");
    if (inheritedDescriptor(path) >= 0) {
        openSpecial();
        return;
    }
    if (!path.has_filename())
        throw Error(ExitStatus::cannotWrite, path.string() + ": is a folder; add a file name to it");

    struct stat status {};
    if (::lstat(path.c_str(), &status) == 0 && S_ISLNK(status.st_mode)) {
        std::error_code error;
        target_ = fs::canonical(path, error);
        if (error && error.value() != ENOENT) fail(error.value());
        if (error) target_ = outputTarget(path);
    }
    if (::stat(target_.c_str(), &status) == 0) {
        if (S_ISDIR(status.st_mode)) fail(EISDIR);
        if (!S_ISREG(status.st_mode)) {
            openSpecial();
            return;
        }
        requireNoInput(path);
        replaces_ = true;
        // rename() would replace a read-only file, but a user who made it read-only wants to keep it.
        if (::faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0)
            throw Error(ExitStatus::cannotWrite, path.string() + ": is read-only; choose another name or chmod u+w it");
    } else if (errno != ENOENT) {
        fail(errno);
    }
    sweepStrays(target_);
    createTemporary();
    if (replaces_) ::fchmod(descriptor_, status.st_mode & 0777); // best effort; some file systems have no mode bits
}

OutputFile::~OutputFile() {
    if (!temporary_.empty()) repeated([this] { return ::unlink(temporary_.c_str()); });
    listed_.strike();
    if (descriptor_ >= 0) ::close(descriptor_);
    if (lock_ >= 0) ::close(lock_);
}

/// A pipe without a reader is refused (ENXIO), because waiting for a reader could take for ever.
void OutputFile::openSpecial() {
    const int inherited = inheritedDescriptor(shown_);
    descriptor_ = inherited >= 0 ? ::fcntl(inherited, F_DUPFD_CLOEXEC, 0)
                                 : ::open(target_.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    if (descriptor_ < 0) fail(errno);
}

void OutputFile::createTemporary() {
    static std::atomic<unsigned> counter{0};
    const fs::path start = folderOf(target_) / (temporaryPrefix(target_) + std::to_string(::getpid()) + ".");
    for (;;) {
        const std::string name = start.string() + std::to_string(counter++);
        // O_EXCL: never follows a link or opens a file that another process has created.
        const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (descriptor < 0 && (errno == EEXIST || errno == EINTR)) continue;
        if (descriptor < 0) fail(errno);
        // Between open and flock another run may have removed the file; then the next name is tried. On a file system
        // without locks only the removal of strays is lost.
        struct stat status {};
        const bool taken = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
        if (taken || (::fstat(descriptor, &status) == 0 && status.st_nlink == 0)) {
            ::close(descriptor);
            continue;
        }
        descriptor_ = descriptor;
        temporary_ = name;
        listed_.list(name);
        lock_ = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
        return;
    }
}

void OutputFile::fail(int errorNumber) const {
    throw Error(ExitStatus::cannotWrite, outputErrorText(shown_, errorNumber, replaces_));
}

void OutputFile::write(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written > 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        } else if (written < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) { // a full pipe
            pollfd waiting{descriptor_, POLLOUT, 0};
            ::poll(&waiting, 1, -1);
        } else if (written == 0 || errno != EINTR) {
            fail(written == 0 ? EIO : errno);
        }
    }
}

void OutputFile::write(std::string_view text) {
    write(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void OutputFile::commit() {
    const bool renames = !temporary_.empty();
    // Without fsync a crash of the machine after the rename can leave the new name on an empty file. Some file systems
    // cannot do it and say so (EINVAL, ENOSYS, ENOTSUP); that is no fault of the file.
    if (renames && repeated([this] { return ::fsync(descriptor_); }) != 0 && errno != EINVAL && errno != ENOSYS &&
        errno != ENOTSUP)
        fail(errno);
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0 && errno != EINTR) fail(errno); // NFS reports a full disk here; on EINTR it is closed
    if (!renames) return;
    if (repeated([this] { return ::rename(temporary_.c_str(), target_.c_str()); }) != 0) fail(errno);
    temporary_.clear();
    listed_.strike();
    // The new name itself lasts once the folder is on disk. The file is whole either way, so a refusal is not an error.
    const int folder = ::open(folderOf(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder >= 0) {
        ::fsync(folder);
        ::close(folder);
    }
}

void writeWhole(const fs::path& path, std::span<const std::uint8_t> bytes) {
    OutputFile file(path);
    file.write(bytes);
    file.commit();
}

void writeWhole(const fs::path& path, std::string_view text) {
    writeWhole(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void probeWritable(const fs::path& path) {
    struct stat status {};
    const bool special = inheritedDescriptor(path) < 0 && ::stat(path.c_str(), &status) == 0 &&
                         !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
    // Opening and closing a pipe would send its reader an end of file, so only the permission is checked.
    if (special && ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0)
        throw Error(ExitStatus::cannotWrite, outputErrorText(path, errno, false));
    if (!special) OutputFile probe(path); // makes the temporary, removes it again
}

fs::path outputTarget(const fs::path& path) {
    std::error_code failed;
    fs::path target = path;
    constexpr int kMostLinks = 40; // as Linux follows
    for (int links = 0; fs::is_symlink(fs::symlink_status(target, failed)); ++links) {
        if (links == kMostLinks) return path;
        target = folderOf(target) / fs::read_symlink(target, failed); // an absolute target replaces the folder
    }
    const fs::path whole = fs::absolute(target, failed); // links are resolved up to the first part that does not exist
    const fs::path resolved = failed ? target : fs::weakly_canonical(whole, failed);
    return failed ? target : resolved;
}

void keepInput(const fs::path& file) {
    std::error_code failed;
    const fs::path canonical = fs::canonical(file, failed);
    const std::lock_guard lock(inputs().mutex);
    if (!failed) inputs().files.insert(canonical);
}

void requireNoInput(const fs::path& path) {
    std::error_code ignored;
    const fs::path file = fs::canonical(path, ignored);
    const std::lock_guard lock(inputs().mutex);
    if (inputs().files.contains(file))
        throw Error(ExitStatus::usage, path.string() + ": is a file that is read; choose another name");
}

} // namespace shadowlab::image
