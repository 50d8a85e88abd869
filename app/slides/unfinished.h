// What is drawn so far of decks whose run has not come to its end, in the folder that they are drawn into: it goes on from
// wherever it was stopped.
//
//     DIR/unfinished/DECK-01-NAME.json     a slide whose files stand: what they were made from, and their digests
//
// Every file is whole or not there. A slide stands only if it was made from what it would be made from now, and if its files are
// what was written then. The parts of a run that came to its end are taken away, so the next one draws everything anew.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace shadowlab::slides {

/// A slide's files by their names below the folder; that of the whole slide comes first.
using SlideFiles = std::vector<std::filesystem::path>;

class Unfinished {
public:
    explicit Unfinished(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// The bytes of a slide's first file where all of them stand. `madeFrom`: a digest of all that they depend on.
    [[nodiscard]] std::optional<std::vector<std::uint8_t>> find(const std::string& slide, const std::string& madeFrom,
                                                                const SlideFiles& files) const;
    /// Once the files are written; `digests` are those of their bytes. Throws Error (cannotWrite).
    void keep(const std::string& slide, const std::string& madeFrom, const std::vector<std::string>& digests) const;
    /// The run has come to its end. Of a deck: also slides that it had once, under other names.
    void discard(const std::string& slide) const;
    void discardDeck(const std::string& deck) const;

private:
    [[nodiscard]] std::filesystem::path parts() const { return folder_ / "unfinished"; }
    [[nodiscard]] std::filesystem::path partOf(const std::string& slide) const { return parts() / (slide + ".json"); }

    std::filesystem::path folder_;
};

} // namespace shadowlab::slides
