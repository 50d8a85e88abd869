// Folders for outputs: one that may be there already, and one that appears whole or not at all, as files do.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "techniques/foundation/image/temporaries.h"

namespace shadowlab::image {

/// Makes a folder, and those above it that are not there. Throws Error (cannotWrite) with the reason and the mend.
void makeFolders(const std::filesystem::path& folder);

/// Keeps other runs of the program that ask for the same out of a folder while a free name is chosen there and taken. Best effort:
/// who holds it for two seconds has been stopped, and file systems without locks have none.
class FolderLock {
public:
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int descriptor_ = -1;
};

/// A new folder on its way. Destroyed before commit(), it leaves nothing behind.
class OutputFolder {
public:
    /// Creates `.NAME.tmp.PID.N` beside the folder that is to be; sweeps up what runs have left that were killed.
    explicit OutputFolder(const std::filesystem::path& target);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    /// What is written in here, is in the new folder.
    [[nodiscard]] const std::filesystem::path& path() const { return temporary_; }
    /// Gives the folder its name. It replaces nothing but an empty folder.
    void commit();

private:
    [[noreturn]] void fail(int errorNumber) const;

    std::filesystem::path target_, temporary_;
    ListedTemporary listed_;
    int lock_ = -1; ///< the temporary, open; tells other runs that it is in use
};

} // namespace shadowlab::image
