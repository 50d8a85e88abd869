// Guarded file access with POSIX calls: the checks are made on the opened file, not on its name, so nothing can be
// swapped in between.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/load/file_access.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

namespace {

/// A file descriptor that closes itself.
class OpenFile {
public:
    // O_NONBLOCK: opening a FIFO without a writer would otherwise wait for ever.
    explicit OpenFile(const std::filesystem::path& file) {
        do {
            descriptor_ = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
            error_ = errno;
        } while (descriptor_ < 0 && error_ == EINTR); // on file systems of a network
    }
    ~OpenFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    /// Why it cannot be read as a regular file; empty when it can. Fills in the size.
    std::string fault() {
        if (descriptor_ < 0) return std::generic_category().message(error_);
        struct stat status {};
        if (::fstat(descriptor_, &status) != 0) return std::generic_category().message(errno);
        if (S_ISDIR(status.st_mode)) return "is a directory";
        if (!S_ISREG(status.st_mode)) return "is not a regular file";
        size_ = static_cast<std::uint64_t>(status.st_size);
        return {};
    }
    [[nodiscard]] std::uint64_t size() const { return size_; }
    [[nodiscard]] int descriptor() const { return descriptor_; }

private:
    int descriptor_ = -1;
    int error_ = 0;
    std::uint64_t size_ = 0;
};

/// "cannot read: No such file ..." or "is a directory": what stands after the file's name.
std::string faultSentence(const std::string& fault) {
    return fault.starts_with("is ") ? fault : "cannot be read: " + fault;
}

/// A folder counts as inside itself; reading it as a file fails later with its own message.
bool isInside(const std::filesystem::path& file, const std::filesystem::path& folder) {
    const auto [folderRest, ignored] = std::ranges::mismatch(folder, file);
    return folderRest == folder.end();
}

} // namespace

std::string whyUnreadable(const std::filesystem::path& file) {
    const std::string fault = OpenFile(file).fault();
    return fault.empty() ? fault : faultSentence(fault);
}

std::string readFile(const std::filesystem::path& file, std::uint64_t maximumBytes, std::string_view limit) {
    OpenFile open(file);
    if (const std::string fault = open.fault(); !fault.empty())
        throw Error(ExitStatus::badInput,
                    shownPath(file) + ": " + faultSentence(fault) + "; give the path of a readable file");
    const auto refuseSize = [&](const std::string& size) {
        throw Error(ExitStatus::overLimit,
                    shownPath(file) + ": " + size + " is more than the limit of " + counted(maximumBytes, "byte") +
                        "; split the file or simplify it" +
                        (limit.empty() ? "" : ", or set --limit " + std::string(limit) + "=VALUE"));
    };
    if (open.size() > maximumBytes) refuseSize(counted(open.size(), "byte"));

    // Read to the end and not just `size` bytes: a file may grow, and some (in /proc) claim to be empty.
    std::string text;
    std::uint64_t filled = 0;
    text.resize(std::max<std::uint64_t>(open.size() + 1, 4096));
    for (;;) {
        const ssize_t got = ::read(open.descriptor(), text.data() + filled, text.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0)
            throw Error(ExitStatus::badInput, shownPath(file) + ": cannot be read: " +
                                                  std::generic_category().message(errno) + "; check the disk");
        if (got == 0) break;
        filled += static_cast<std::uint64_t>(got);
        if (filled > maximumBytes) refuseSize("its content");
        if (filled == text.size()) text.resize(2 * text.size());
    }
    text.resize(filled);
    return text;
}

AllowedFolders::AllowedFolders(const std::filesystem::path& referringFile, const LoadOptions& options)
    : base_(referringFile.parent_path().empty() ? std::filesystem::path(".") : referringFile.parent_path()) {
    const auto allow = [this](const std::filesystem::path& folder) {
        std::error_code error;
        const std::filesystem::path canonical = std::filesystem::canonical(folder, error);
        if (!error) folders_.push_back(canonical);
    };
    allow(base_);
    if (!options.assetsRoot.empty()) allow(options.assetsRoot);
    for (const std::filesystem::path& folder : options.allowed)
        allow(folder);
}

std::optional<std::filesystem::path> AllowedFolders::resolve(std::string_view reference) const {
    if (reference.empty() || reference.find('\0') != std::string_view::npos) return std::nullopt;
    std::error_code error;
    // weakly_canonical follows every symbolic link of the part that exists, so that a link cannot lead out.
    const std::filesystem::path absolute = std::filesystem::absolute(base_ / reference, error);
    if (error) return std::nullopt;
    std::filesystem::path file = std::filesystem::weakly_canonical(absolute, error);
    // A cycle of links, or a name that is too long: opening the file fails later with its own message.
    if (error) file = absolute.lexically_normal();
    const bool inside = std::ranges::any_of(folders_, [&](const auto& folder) { return isInside(file, folder); });
    return inside ? std::optional(std::move(file)) : std::nullopt;
}

} // namespace shadowlab::scene
