// Files whose names were written for another computer: with backslashes, a drive, quotes, a comment behind them, or letters in another
// case. They are looked for where a reference may lead anyway, and nowhere else.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/scene/load/file_access.h"

namespace shadowlab::scene {

/// `text` up to a blank that is followed by `#`; all of it where there is none.
std::string_view withoutComment(std::string_view text);

/// Letters made small: ASCII, Latin-1, Greek and Cyrillic ones. Equal for names that differ in the case of their letters alone.
std::string inSmallLetters(std::string_view text);

class MisnamedFiles {
public:
    /// `folders` must outlive this.
    explicit MisnamedFiles(const AllowedFolders& folders) : folders_(folders) {}

    /// Is there anything of this name in an allowed folder, as it is written?
    [[nodiscard]] bool isThere(const std::string& reference) const;

    /// A reference to an existing regular file in an allowed folder that differs from `reference` only in how it is written. Tried
    /// in this order: without quotes; "\ " as a blank, other backslashes as slashes; an absolute path by its last parts,
    /// the longest first; letters in another case, where one file alone fits; all this without a trailing comment.
    /// `inFolder` is the folder that the name is relative to, itself relative to that of the referring file.
    [[nodiscard]] std::optional<std::string> find(const std::string& reference, const std::string& inFolder = {});

    /// The reference as it is written, or what find() makes of it where there is nothing of that name and something alike.
    [[nodiscard]] std::string asFound(const std::string& reference);

    /// Of the last find() that found none: ` ("A.png" and "a.PNG" differ from it in case alone)`, where there were several.
    [[nodiscard]] std::string severalAlike() const;

private:
    using Listing = std::map<std::string, std::vector<std::string>>; ///< names as they are, by inSmallLetters

    std::optional<std::string> inAnyCase(const std::string& reference, const std::string& inFolder);
    const Listing& listing(const std::filesystem::path& canonicalFolder);

    const AllowedFolders& folders_;
    std::map<std::filesystem::path, Listing> listings_; ///< a file may name thousands of missing ones
    std::vector<std::string> alike_;                    ///< names between which the last find() did not guess
};

/// One note for all files of a kind that were found under another name.
class MisnamedFilesNote {
public:
    /// `what` is as in "material file".
    explicit MisnamedFilesNote(std::string_view what) : what_(what) {}
    void add(const std::string& place, const std::string& written, const std::string& found);
    /// Nothing when none was added.
    void appendTo(std::vector<std::string>& notes) const;

private:
    std::string what_, first_;
    std::vector<std::string> written_; ///< each once
};

} // namespace shadowlab::scene
