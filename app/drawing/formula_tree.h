// What a formula consists of: a tree, made by the reader (formula_parse.cpp), set by formula.cpp.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "app/drawing/formula.h"

namespace shadowlab::drawing {

struct Formula::Node {
    enum class Kind {
        row,       ///< children side by side
        variable,  ///< letters that lean
        upright,   ///< digits, words
        function,  ///< its name, with a little space before what it is of
        bold,      ///< vectors
        operation, ///< + - =, with space around
        opening,   ///< after it a minus is a sign
        mark,      ///< a comma: space after it only
        space,     ///< `text` is empty, `size` em wide
        large,     ///< a sum, an integral: child 0 is what is below or at its foot, 1 above; either may be an empty row
        scripts,   ///< child 0 with child 1 lowered and child 2 raised; either may be an empty row
        fraction,  ///< child 0 over child 1
        root,      ///< child 0 below a root sign
        fenced,    ///< child 0 between signs as high as it is: the first letter of `text`, and the last; '.' is none
        matrix,    ///< children row by row, `columns` in each
    };
    Kind kind = Kind::row;
    std::string text;
    double size = 0;
    int columns = 0;
    bool hasLimits = false; ///< of large: below and above the sign, not beside it
    std::vector<Node> children;
};

/// Throws Error (badInput) as Formula's constructor does.
Formula::Node parseFormula(std::string_view tex);

} // namespace shadowlab::drawing
