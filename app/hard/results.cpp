// SPDX-License-Identifier: MIT
#include "app/hard/results.h"

#include <algorithm>

namespace shadowlab::hard {

std::string_view toText(Outcome outcome) {
    switch (outcome) {
    case Outcome::right: return "right";
    case Outcome::wrong: return "wrong";
    case Outcome::provesNothing: return "proves nothing";
    }
    return "";
}

std::string_view toText(Standing standing) {
    switch (standing) {
    case Standing::exact: return "exact";
    case Standing::edges: return "edges";
    case Standing::wrong: return "wrong";
    case Standing::provesNothing: return "proves nothing";
    case Standing::refused: return "refused";
    }
    return "";
}

int CaseResult::red() const {
    return static_cast<int>(std::ranges::count(rows, false, &Row::isGreen) +
                            std::ranges::count(cells, false, &Cell::isGreen));
}

} // namespace shadowlab::hard
