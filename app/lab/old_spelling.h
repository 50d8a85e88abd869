// Two techniques were parameters of the shadow map once: `shadow-map.exact=true` is the technique `shadow-map-exact` now, and
// `shadow-map.alias-free=true` is `shadow-map-alias-free`. Command lines, lessons, decks and hard cases that people have kept go
// on working: here, and nowhere else, the old words are turned into the new ones.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace shadowlab::lab {

/// Where notes about old words go from now on, a sentence each, and each only once; none: nowhere.
void tellOldSpelling(void (*note)(std::string_view sentence));

/// Techniques, stages and settings that belong together, as they were written: on one command line, or of one picture.
class OldSpelling {
public:
    /// `stages`: of each technique the id of the stage it shows, or "". `settings`: as applySettings() takes them, in order.
    OldSpelling(std::vector<std::string> techniques, const std::vector<std::string>& stages,
                const std::vector<std::string>& settings);

    /// The techniques as they are called now.
    [[nodiscard]] const std::vector<std::string>& techniques() const { return now_; }
    /// What one of the settings means now: itself; or one setting for each slot that it is about; or nothing, if it is the old
    /// switch, or about a parameter that the new technique does not have. Throws Error (usage) for a switch that is set to
    /// neither true nor false.
    [[nodiscard]] std::vector<std::string> today(const std::string& setting) const;

private:
    std::vector<std::string> written_, now_; ///< techniques, by slot
};

/// Replaces both by what they mean now.
void respell(std::vector<std::string>& techniques, const std::vector<std::string>& stages,
             std::vector<std::string>& settings);

} // namespace shadowlab::lab
