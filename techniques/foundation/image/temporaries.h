// What outputs are made of while they are under way: files and folders with names of their own, in a list that also a signal
// handler can walk.
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

    /// From now on it is removed with the others. Beyond the list's room, and with a path that is too long, it is left to its
    /// owner's destructor and, after a kill, to the next run.
    void list(const std::string& path);
    /// It is no temporary any more.
    void strike();

private:
    int place_ = -1;
};

/// Removes every file in the list, and every folder with all that is in it. Async-signal-safe: for the handler that is about to
/// _exit.
void removeTemporariesNow() noexcept;

} // namespace shadowlab::image
