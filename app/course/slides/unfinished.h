// The slides drawn so far by an interrupted run, so that the next run continues from there:
//
//     DIR/DECK.unfinished.json     the finished slides: digests of their inputs, and of their files
//
// The file is replaced atomically after every slide. A slide counts as finished only if its inputs are the same as now, and its files
// are unchanged. A run that completes deletes the file, so that the next one draws everything again. A file of that name which this
// program did not write is left as it is.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/drawing/labels.h"

namespace shadowlab::course {

/// A slide's files by their names below the folder; that of the whole slide comes first.
using SlideFiles = std::vector<std::filesystem::path>;

/// A slide that stands from an earlier run.
struct StandingSlide {
    std::vector<std::uint8_t> png; ///< its first file's bytes
    drawing::Box picturesAt;       ///< as DrawnSlide has it
};

class Unfinished {
public:
    Unfinished(std::filesystem::path folder, const std::string& deck)
        : folder_(std::move(folder)), file_(folder_ / (deck + ".unfinished.json")) {}

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    /// Whether another program's file is in its place. Then nothing is stored.
    [[nodiscard]] bool isForeign() const;

    /// A slide, if all of its files are finished. `madeFrom`: a digest of all that they depend on.
    [[nodiscard]] std::optional<StandingSlide> find(const std::string& slide, const std::string& madeFrom,
                                                    const SlideFiles& files) const;
    /// Once the files are written; `digests` are those of their bytes. Throws Error (cannotWrite).
    void keep(const std::string& slide, const std::string& madeFrom, const std::vector<std::string>& digests,
              const drawing::Box& picturesAt) const;
    /// Called when a run that drew only these slides is complete. Throws Error (cannotWrite).
    void discard(const std::vector<std::string>& slides) const;
    /// A run that drew the whole deck has.
    void discardAll() const;

private:
    std::filesystem::path folder_, file_;
};

} // namespace shadowlab::course
