// The list of temporary files and folders of unfinished outputs. A signal handler can walk it, so that a killed run removes
// them.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace shadowlab::image {

/// One temporary file or folder in the list, for as long as this lives.
class ListedTemporary {
public:
    ListedTemporary() = default;
    ~ListedTemporary() { strike(); }
    ListedTemporary(const ListedTemporary&) = delete;
    ListedTemporary& operator=(const ListedTemporary&) = delete;

    /// From now on it is removed with the others. If the list is full or the path too long, its owner's destructor removes
    /// it or, after a kill, the next run.
    void list(const std::string& path);
    /// Takes it off the list.
    void strike();

private:
    int place_ = -1;
};

/// Removes every file in the list, and every folder with all that is in it. Async-signal-safe: for the handler that is about to
/// _exit.
void removeTemporariesNow() noexcept;

} // namespace shadowlab::image
