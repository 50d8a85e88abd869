// Checks the indices of one kind of OBJ vertex data (v, vt or vn): positive ones count from 1 and may point ahead,
// negative ones count back from the last line so far.
// SPDX-License-Identifier: MIT
#pragma once
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/load/unusual_characters.h"
#include "techniques/foundation/scene/obj/statement_lines.h"

namespace shadowlab::scene {

/// Counts the lines of the kind, and remembers the indices that pointed ahead.
class IndexSpace {
public:
    IndexSpace(std::string_view what, std::string_view statement) : what_(what), statement_(statement) {}

    std::uint64_t count = 0;

    /// The absolute index (from 1) for what the file says.
    std::uint64_t resolve(std::string_view text, const StatementLines& lines) {
        std::int64_t index = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
        if (error != std::errc{} || end != text.data() + text.size())
            lines.fail(inQuotes(text, 40) + " is not a valid " + what_ + " index" +
                       (unusualCharacter(text)
                            ? unusualCharacterHint(text)
                            : "; write a whole number from 1 to the number of \"" + statement_ + "\" lines"));
        if (index == 0) lines.fail(what_ + " index 0; OBJ counts from 1 (or from -1 backwards)");
        if (index < 0) {
            if (static_cast<std::uint64_t>(-(index + 1)) >= count)
                lines.fail(what_ + " index " + std::to_string(index) + ", but only " + has(count) +
                           " so far; fix the face or add the missing lines before it");
            return count - static_cast<std::uint64_t>(-(index + 1));
        }
        const auto positive = static_cast<std::uint64_t>(index);
        // Of the indices that point ahead, only those larger than all before can be the first one out of range.
        if (positive > count && (ahead_.empty() || positive > ahead_.back().index))
            ahead_.push_back({positive, lines.line()});
        return positive;
    }

    struct Ahead {
        std::uint64_t index;
        std::size_t line;
    };
    /// The first index beyond the final count; nullptr when there is none.
    [[nodiscard]] const Ahead* firstOutOfRange() const {
        for (const Ahead& ahead : ahead_)
            if (ahead.index > count) return &ahead;
        return nullptr;
    }
    [[nodiscard]] std::string outOfRangeMessage(const Ahead& ahead) const {
        return what_ + " index " + std::to_string(ahead.index) + ", but the file has only " + has(count) +
               "; fix the face or add the missing lines";
    }

private:
    [[nodiscard]] std::string has(std::uint64_t n) const { return counted(n, "\"" + statement_ + "\" line"); }

    std::string what_, statement_;
    std::vector<Ahead> ahead_;
};

} // namespace shadowlab::scene
