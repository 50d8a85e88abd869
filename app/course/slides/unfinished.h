// What is drawn so far of a deck whose run has not come to its end, so that it goes on from wherever it was stopped:
//
//     DIR/DECK.unfinished.json     the slides that stand: what their files were made from, and their digests
//
// It is whole or not there, and rewritten after every slide. A slide stands only if it was made from what it would be made from
// now, and if its files are what was written then. A run that came to its end takes the file away, so the next one draws
// everything anew. A file of that name which this program did not write is left as it is.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace shadowlab::course {

/// A slide's files by their names below the folder; that of the whole slide comes first.
using SlideFiles = std::vector<std::filesystem::path>;

class Unfinished {
public:
    Unfinished(std::filesystem::path folder, const std::string& deck)
        : folder_(std::move(folder)), file_(folder_ / (deck + ".unfinished.json")) {}

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    /// Is there something else in its place? Then nothing is kept.
    [[nodiscard]] bool isForeign() const;

    /// The bytes of a slide's first file where all of them stand. `madeFrom`: a digest of all that they depend on.
    [[nodiscard]] std::optional<std::vector<std::uint8_t>> find(const std::string& slide, const std::string& madeFrom,
                                                                const SlideFiles& files) const;
    /// Once the files are written; `digests` are those of their bytes. Throws Error (cannotWrite).
    void keep(const std::string& slide, const std::string& madeFrom, const std::vector<std::string>& digests) const;
    /// A run that drew only these slides has come to its end. Throws Error (cannotWrite).
    void discard(const std::vector<std::string>& slides) const;
    /// A run that drew the whole deck has.
    void discardAll() const;

private:
    std::filesystem::path folder_, file_;
};

} // namespace shadowlab::course
