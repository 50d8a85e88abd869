// Reading the files a scene is made of: regular files only, never larger than agreed, and only from allowed folders.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::scene {

/// Why `file` cannot be read ("is a directory", "No such file or directory" ...); empty when it is a readable regular
/// file.
std::string whyUnreadable(const std::filesystem::path& file);

/// The whole file. Throws Error: badInput when it is no readable regular file, overLimit beyond `maximumBytes`, which
/// `limit` is the name of, if it is one that can be set. A FIFO or a device never makes it wait.
std::string readFile(const std::filesystem::path& file, std::uint64_t maximumBytes, std::string_view limit = {});

/// The folders a scene may take files from: its own folder tree, the assets root, and what the user allowed.
/// A scene is data from somewhere; without this fence it could name, and show pieces of, any file of its user.
class AllowedFolders {
public:
    /// `referringFile` is the scene or mesh whose references are to be resolved, relative to its folder.
    AllowedFolders(const std::filesystem::path& referringFile, const LoadOptions& options);

    /// The file meant, with symbolic links resolved; nothing when it lies outside the allowed folders.
    [[nodiscard]] std::optional<std::filesystem::path> resolve(std::string_view reference) const;

private:
    std::filesystem::path base_;
    std::vector<std::filesystem::path> folders_; ///< canonical
};

/// What every refusal by AllowedFolders says after the reference.
inline constexpr std::string_view kOutsideMessage = "lies outside the folders this scene may read; move the file "
                                                    "beside the scene, or allow its folder with --allow DIR";

} // namespace shadowlab::scene
