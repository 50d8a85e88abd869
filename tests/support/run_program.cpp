// The output goes to files in memory, not into pipes: nothing can block, however much is said.
// SPDX-License-Identifier: MIT
#include "tests/support/run_program.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

namespace shadowlab::testing {

namespace {

std::string contentOf(int descriptor) {
    std::string content;
    std::array<char, 4096> block{};
    ::lseek(descriptor, 0, SEEK_SET);
    for (ssize_t count = 0; (count = ::read(descriptor, block.data(), block.size())) > 0;)
        content.append(block.data(), static_cast<std::size_t>(count));
    return content;
}

[[noreturn]] void become(std::vector<std::string>& argv, const ProgramSetting& setting, int out, int err) {
    if (::chdir(setting.folder.c_str()) != 0) ::_exit(126);
    for (const auto& [name, value] : setting.environment)
        value.empty() ? ::unsetenv(name.c_str()) : ::setenv(name.c_str(), value.c_str(), 1);
    const int nothing = ::open("/dev/null", O_RDONLY);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE})
        ::signal(signal, SIG_DFL); // a shell may have ignored them for us
    if (setting.inChild) setting.inChild();
    std::vector<char*> words;
    for (std::string& word : argv)
        words.push_back(word.data());
    words.push_back(nullptr);
    ::execv(words.front(), words.data());
    ::_exit(127);
}

} // namespace

std::string ProgramResult::shown() const {
    return "status " + std::to_string(status) + (timedOut ? ", timed out" : "") + "\nstdout: " + out.substr(0, 2000) +
           "\nstderr: " + err.substr(0, 2000);
}

RunningProgram::RunningProgram(std::vector<std::string> argv, const ProgramSetting& setting)
    : out_(::memfd_create("stdout", MFD_CLOEXEC)), err_(::memfd_create("stderr", MFD_CLOEXEC)),
      timeoutSeconds_(setting.timeoutSeconds) {
    process_ = ::fork();
    if (process_ == 0) become(argv, setting, out_, err_);
}

RunningProgram::~RunningProgram() {
    if (!hasEnded()) {
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
    }
    ::close(out_);
    ::close(err_);
}

void RunningProgram::signal(int number) const { ::kill(process_, number); }

bool RunningProgram::hasEnded() {
    if (!ended_) ended_ = process_ <= 0 || ::waitpid(process_, &rawStatus_, WNOHANG) == process_;
    return ended_;
}

ProgramResult RunningProgram::wait() {
    ProgramResult result;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(timeoutSeconds_);
    while (!hasEnded()) {
        if (!result.timedOut && std::chrono::steady_clock::now() > end) {
            result.timedOut = true;
            ::kill(process_, SIGKILL);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    result.status = WIFSIGNALED(rawStatus_) ? 128 + WTERMSIG(rawStatus_) : WEXITSTATUS(rawStatus_);
    result.out = contentOf(out_);
    result.err = contentOf(err_);
    return result;
}

ProgramResult runProgram(std::vector<std::string> argv, const ProgramSetting& setting) {
    return RunningProgram(std::move(argv), setting).wait();
}

} // namespace shadowlab::testing
