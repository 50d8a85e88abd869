// The statements of an OBJ file that the scan does not read. None is left out without a word: geometry that is not drawn gets a note,
// and a line that was probably meant as a vertex or a face is an error, because the indices of all later lines would be off by one.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "techniques/foundation/scene/obj/statement_lines.h"

namespace shadowlab::scene {

class OtherStatements {
public:
    /// Takes the statement that `lines` stands at. It is remembered as a fault where it looks like v, vn, vt or f.
    void take(const StatementLines& lines);

    /// Counts what `lines` stands at under `what`, for a note.
    void count(const StatementLines& lines, std::string_view what);

    [[nodiscard]] bool hasFault() const { return faultLine_ > 0; }
    /// Is the fault one of a single character (`V`, a no-break space), so that the file is surely OBJ?
    [[nodiscard]] bool isCloseFault() const { return isCloseFault_; }
    /// Throws the Error for the first fault.
    [[noreturn]] void failAtFault(const StatementLines& lines) const;

    /// ", and l (lines) is not drawn" of the first such kind; empty where there is none.
    [[nodiscard]] std::string firstUndrawn() const;

    /// One for each kind: the first line, and how often.
    [[nodiscard]] std::vector<std::string> notes(const StatementLines& lines) const;

private:
    struct Kind {
        std::string what;
        std::size_t firstLine;
        std::uint64_t count;
    };
    void rememberFault(const StatementLines& lines, const std::string& message, bool isClose);
    void countUnknown(const StatementLines& lines);

    std::vector<Kind> kinds_;
    std::string firstUndrawn_;
    std::size_t unknownKinds_ = 0, faultLine_ = 0;
    std::string fault_;
    bool isCloseFault_ = false;
};

} // namespace shadowlab::scene
