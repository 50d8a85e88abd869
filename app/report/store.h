// A report's folder: the plan, and the results so far, a file for each point and one for the times of each group.
//
//     DIR/plan.json                             what all shards of the report have in common
//     DIR/parts/GROUP/POINT.json, .png, -errors.png
//     DIR/parts/GROUP/times-1-of-1.json         rewritten whole after every round
//     DIR/parts/machine-1-of-1.json
//
// Every file is written atomically, so that a report gontinues from where it was interrupted.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <filesystem>
#include <optional>

#include "app/report/frame_timer.h"
#include "app/report/judge.h"
#include "app/report/plan.h"

namespace shadowlab::report {

class Store {
public:
    explicit Store(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Makes the folder, or finds the report that was begun in it. Throws Error: badInput where it holds another one.
    void begin(const Plan& plan) const;
    /// The plan of a folder. Throws Error (badInput) where there is none, or one that cannot be read.
    [[nodiscard]] Plan plan() const;

    /// None, too, where one of its pictures is not as it was drawn: the point has to be judged again.
    [[nodiscard]] std::optional<Judge::Judged> judged(const PlannedGroup& group, const PointKey& point) const;
    void keep(const PlannedGroup& group, const PointKey& point, const Judge::Judged& judged) const;

    /// Of that shard; empty: none so far.
    [[nodiscard]] Times times(const PlannedGroup& group, const Shard& shard) const;
    void keep(const PlannedGroup& group, const Shard& shard, const Times& times) const;
    void keep(const Shard& shard, const Machine& machine) const;

    /// The shards that have left anything here, in their order.
    [[nodiscard]] std::vector<Shard> shards() const;
    [[nodiscard]] Machine machine(const Shard& shard) const;

    /// Throws Error (badInput) with its name for a file that cannot be read, or that is not as this program wrote it.
    void readAll() const;
    /// Takes over all parts of another report. Throws Error (badInput) where both have a point and do not agree.
    void takeOver(const Store& other) const;

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

private:
    /// A point, and which of its two pictures are as they were drawn.
    struct Part {
        Judge::Judged judged;
        std::array<bool, 2> isWhole;
    };
    [[nodiscard]] std::optional<Part> part(const PlannedGroup& group, const PointKey& point) const;

    [[nodiscard]] std::filesystem::path groupFolder(const PlannedGroup& group) const;
    /// Without an ending.
    [[nodiscard]] std::filesystem::path pointFile(const PlannedGroup& group, const PointKey& point) const;

    std::filesystem::path folder_;
};

/// As a file name: characters with a meaning to a file system or a shell become '_'; a number behind distinguishes names that
/// would become equal.
std::string fileName(const std::string& name);

} // namespace shadowlab::report
