// Folders for outputs: one that may be there already, and one that appears whole or not at all, as files do.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>

#include "techniques/foundation/image/temporaries.h"

namespace shadowlab::image {

/// Makes a folder, and those above it that are not there. Throws Error (cannotWrite) with the reason and the remedy.
void makeFolders(const std::filesystem::path& folder);

/// A lock on a folder, held while a free name is chosen and taken there, so that two runs of the program do not choose the
/// same. Best effort: after two seconds the holder counts as stopped, and some file systems have no locks.
class FolderLock {
public:
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int descriptor_ = -1;
};

/// One output folder while it is filled. If it is destroyed before commit(), the temporary is removed.
class OutputFolder {
public:
    /// Creates `.NAME.tmp.PID.N` beside the folder that is to be; removes temporaries of runs that were killed.
    explicit OutputFolder(const std::filesystem::path& target);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    /// Write the contents of the new folder here.
    [[nodiscard]] const std::filesystem::path& path() const { return temporary_; }
    /// Gives the folder its name. It replaces nothing but an empty folder.
    void commit();

private:
    [[noreturn]] void fail(int errorNumber) const;

    std::filesystem::path target_, temporary_;
    ListedTemporary listed_;
    int lock_ = -1; ///< the temporary, open; tells other runs that it is in use
};

/// Makes a folder, whole or not at all: `fill` writes its contents into the folder that it is told. Throws Error (cannotWrite) if
/// there is something of that name; errors of `fill` name the folder as it was asked for, not the temporary one.
void writeFolder(const std::filesystem::path& folder, const std::function<void(const std::filesystem::path&)>& fill);

} // namespace shadowlab::image
