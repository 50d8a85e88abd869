// Runs a program as a user would: another process, its own folder and environment, everything it says captured.
// SPDX-License-Identifier: MIT
#pragma once
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace shadowlab::testing {

struct ProgramResult {
    int status = -1;       ///< exit status; 128 + signal for one that was killed
    bool timedOut = false; ///< it was killed after the time limit
    std::string out, err;
    [[nodiscard]] std::string shown() const; ///< for failure messages
};

struct ProgramSetting {
    std::filesystem::path folder = ".";
    std::map<std::string, std::string> environment{}; ///< added to ours; an empty text removes the variable
    std::function<void()> inChild{};                  ///< called between fork and exec: only system calls
#ifdef __SANITIZE_ADDRESS__                           // some five times slower
    int timeoutSeconds = 600;
#else
    int timeoutSeconds = 120;
#endif
};

/// A program on its way.
class RunningProgram {
public:
    /// argv[0] is the file to execute. A failed exec is status 127.
    RunningProgram(std::vector<std::string> argv, const ProgramSetting& setting);
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    void signal(int number) const;
    [[nodiscard]] bool hasEnded();
    ProgramResult wait();

private:
    pid_t process_ = -1;
    int out_ = -1, err_ = -1;
    int timeoutSeconds_;
    int rawStatus_ = 0;
    bool ended_ = false;
};

ProgramResult runProgram(std::vector<std::string> argv, const ProgramSetting& setting = {});

} // namespace shadowlab::testing
