// How far a long command is, for whoever sits at a terminal; silent when standard error goes anywhere else.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace shadowlab::commands {

class Progress {
public:
    /// "frame 3 of 60". A single piece of work has no progress to tell.
    Progress(std::string what, int total);
    /// Wipes the line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void done(int count);

private:
    std::string what_;
    int total_;
    bool shown_;
};

} // namespace shadowlab::commands
