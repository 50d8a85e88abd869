// What a glTF file holds and is not shown: one note for each kind, with its first place and how often.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "techniques/foundation/scene/json/json_value.h"

namespace shadowlab::scene {

class GltfNotes {
public:
    /// `what` is the kind, and reads as "is at PLACE: ". `where` is as in "nodes[3]"; `offset` is that in the JSON text.
    void add(const std::string& what, const std::string& where, std::size_t offset, std::uint64_t times = 1) {
        constexpr std::size_t kMostKinds = 40; // more than a file has in earnest: unknown keys may each be another
        const auto found = index_.find(what);
        const bool isNew = found == index_.end();
        if (isNew && kinds_.size() > kMostKinds) {
            kinds_.back().count += times;
            return;
        }
        const bool isLast = isNew && kinds_.size() == kMostKinds;
        if (isNew) kinds_.push_back({isLast ? "more is left out, of further kinds" : what, where, offset, 0});
        kinds_[isNew ? kinds_.size() - 1 : found->second].count += times;
        if (isNew && !isLast) index_.emplace(what, kinds_.size() - 1);
    }

    /// What came up first, as part of a sentence; empty: nothing.
    [[nodiscard]] std::string first() const { return kinds_.empty() ? "" : kinds_.front().where + ": " + kinds_.front().what; }

    /// In the order in which they first came up.
    void appendTo(std::vector<std::string>& notes, const JsonDocument& document) const {
        for (const Kind& kind : kinds_)
            notes.push_back(document.place(kind.offset) + ": " + (kind.where.empty() ? "" : kind.where + ": ") + kind.what +
                            (kind.count > 1 ? " (" + std::to_string(kind.count) + " times in the file)" : ""));
    }

private:
    struct Kind {
        std::string what, where;
        std::size_t offset;
        std::uint64_t count;
    };
    std::vector<Kind> kinds_;
    std::map<std::string, std::size_t> index_;
};

} // namespace shadowlab::scene
