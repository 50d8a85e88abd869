// A child process of this program: started, watched, talked with, and ended with all that it has started.
// SPDX-License-Identifier: MIT
#pragma once
#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "app/student/grading/process_tree.h"

namespace shadowlab::student {

class ChildProcess {
public:
    /// Executes the first of `words`, an absolute path, with the others, as the leader of a process group. It writes no core file, and no
    /// file larger than 1 GiB. Throws Error (overLimit) where no process can be started.
    explicit ChildProcess(const std::vector<std::string>& words);
    /// Ends it, and all that it has started.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Waits some milliseconds, or until it says something, and takes that. Its wait status once it has ended.
    std::optional<int> look();
    [[nodiscard]] TreeUse use() const { return useOf(process_); }
    /// Writes to its standard input. False where it does not read any more.
    bool tell(const std::string& text);
    /// It reads nothing more from its standard input.
    void closeInput();
    void end();

    std::string said, complaints; ///< the last MiB of standard output, and of standard error

private:
    pid_t process_ = -1;
    int in_ = -1, out_ = -1, err_ = -1;
    std::vector<pid_t> before_; ///< children that this process had already
};

} // namespace shadowlab::student
