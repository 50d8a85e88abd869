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

/// The whole file. Throws Error: badInput when it is no readable regular file, overLimit beyond `maximumBytes`, `limit` is
/// the name of that limit if the user can set it. Never blocks on a FIFO or a device.
std::string readFile(const std::filesystem::path& file, std::uint64_t maximumBytes, std::string_view limit = {});

/// The folders a scene may take files from: its own folder tree, the assets root, and what the user allowed. A scene may
/// come from anywhere; without this check it could name any file of the user and show parts of it.
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

/// The text after the reference in every refusal by AllowedFolders.
inline constexpr std::string_view kOutsideMessage = "lies outside the folders this scene may read; move the file "
                                                    "beside the scene, or allow its folder with --allow DIR";

} // namespace shadowlab::scene
