// The files of a packed scene: each source once in a folder, under its own name as far as that is free.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>

namespace shadowlab::scene {

class PackedFiles {
public:
    /// Writes below `root`, which exists.
    explicit PackedFiles(std::filesystem::path root) : root_(std::move(root)) {}

    /// The place of that source in that folder of the packed scene, relative to the root: FOLDER/NAME, or FOLDER/2/NAME where
    /// another source has this name (the files keep their own names, since materials and objects may be called after them).
    /// `text` is asked for what to write, once, when the source is new there; it is told the place.
    std::filesystem::path add(const std::filesystem::path& canonical, const std::filesystem::path& folder,
                              const std::string& name,
                              const std::function<std::string(const std::filesystem::path& place)>& text);

    /// Writes a file that has no source.
    void write(const std::filesystem::path& place, const std::string& text);

    [[nodiscard]] std::size_t count() const { return places_.size(); }

private:
    std::filesystem::path root_;
    std::map<std::pair<std::filesystem::path, std::filesystem::path>, std::filesystem::path>
        places_;                  ///< by folder and source
    std::set<std::string> taken_; ///< in small letters: some file systems do not tell them from capitals
};

} // namespace shadowlab::scene
