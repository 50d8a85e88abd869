// Outputs appear whole or not at all. The bytes go to a temporary beside the target, every step is checked, and only a
// complete file takes the target's name (rename is atomic within a folder). A full disk or a crash leaves the old file.
// Special files (/dev/stdout, /dev/null, pipes) have nothing to rename and are written directly, with the same checks.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "techniques/foundation/image/temporaries.h"

namespace shadowlab::image {

/// One output file while it is written. If it is destroyed before commit(), the temporary is removed and the old file stays
/// as it was. All functions throw Error (cannotWrite) with the reason and the remedy.
class OutputFile {
public:
    /// Creates the temporary `.NAME.tmp.PID.N` in the target's folder, with the mode bits of the file it will replace.
    explicit OutputFile(const std::filesystem::path& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::span<const std::uint8_t> bytes);
    void write(std::string_view text);
    /// fsync, close, rename: after this the file is there, whole.
    void commit();

private:
    void openSpecial();
    void createTemporary();
    [[noreturn]] void fail(int errorNumber) const;

    std::filesystem::path shown_;  ///< as the user wrote it, for messages
    std::filesystem::path target_; ///< symbolic links resolved: a link keeps pointing where it points
    std::string temporary_;        ///< empty when writing directly
    int descriptor_ = -1;
    int lock_ = -1; ///< second descriptor of the temporary; tells other runs that it is in use
    ListedTemporary listed_;
    bool replaces_ = false;
};

/// Writes a whole file at once.
void writeWhole(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void writeWhole(const std::filesystem::path& path, std::string_view text);

/// Finds out before any rendering whether `path` can be written (missing folder, a folder instead of a file, no
/// permission, name too long). Leaves everything as it was. Throws Error (cannotWrite).
void probeWritable(const std::filesystem::path& path);

/// The file that an output of this name is written to: symbolic links resolved, also those to a file that does not exist
/// yet. For a cycle of links, the name itself.
std::filesystem::path outputTarget(const std::filesystem::path& path);

/// From now on no output may replace this file: it is a scene, a mesh, an image, a deck ... that was read. A picture
/// written beside the scene may easily get the name of an image that the scene uses. OutputFile then throws Error (usage).
void keepInput(const std::filesystem::path& file);
/// Throws Error (usage) if `path` leads to such a file: the check of OutputFile, before the work begins.
void requireNoInput(const std::filesystem::path& path);

} // namespace shadowlab::image
