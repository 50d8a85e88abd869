// The results of a run of the hard cases so far, in its folder, from which an interrupted run continues.
//
//     DIR/parts/P2b.json                    a case that is done
//     DIR/pictures/P2b-planar.png, -errors.png
//
// Every file is written atomically. A part counts only if it was made from what the case is made from now: the program, the
// renderer, the size, the techniques, the case's file and its scenes; and if its pictures are as they were written. The parts of
// a completed run are deleted, so the next one measures everything again.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "app/hard/case.h"
#include "app/hard/columns.h"
#include "app/hard/results.h"

namespace shadowlab::hard {

class Parts {
public:
    /// Makes the folders. Throws Error (cannotWrite), also where a file that is no part of a run would be overwritten. `madeBy`: identifies
    /// program, machine and settings, which all parts of one run have in common.
    Parts(std::filesystem::path folder, std::string madeBy, std::span<const Case> cases);

    /// The result of the case; none: it has not been run, or has changed since.
    [[nodiscard]] std::optional<CaseResult> find(const Case& one) const;
    void keep(const Case& one, const CaseResult& result) const;
    /// All is done, and written elsewhere.
    void discard(std::span<const Case> cases) const;

private:
    [[nodiscard]] std::filesystem::path fileOf(const Case& one) const;
    [[nodiscard]] std::string madeFrom(const Case& one) const;

    std::filesystem::path folder_;
    std::string madeBy_;
};

/// Program (a digest), renderer, size and techniques, in words.
std::string madeBy(const std::string& renderer, bool small, std::span<const Column> columns);

} // namespace shadowlab::hard
