// The columns of the table of techniques and cases: every registered technique as it is by default, and every way of one that is
// by its nature exact.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/lab/pane.h"

namespace shadowlab::hard {

struct Column {
    std::string technique;  ///< id
    lab::Values values; ///< what differs from its defaults
    bool isExact = false;   ///< it traces rays wherever the rasteriser may round wrongly: no pixel may be wrong but ties

    /// "shadow-volume-zfail repair=true"
    [[nodiscard]] std::string title() const;
    /// As the reader of cases makes it: what has only defaults has no settings at all.
    [[nodiscard]] lab::PaneState state() const {
        lab::PaneState state{technique, {}, {}};
        if (!values.empty()) state.settings[technique] = values;
        return state;
    }
};

/// In the order of the registry; only techniques that say what they make of one light (stage `visibility`).
std::vector<Column> columns();

} // namespace shadowlab::hard
