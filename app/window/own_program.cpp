// SPDX-License-Identifier: MIT
#include "app/window/own_program.h"

#include <array>
#include <chrono>
#include <cstring>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace shadowlab::window {

namespace {

OwnProgram::Ended run(std::vector<std::string> words) {
    OwnProgram::Ended ended{std::move(words), 70, ""};
    std::vector<char*> arguments{const_cast<char*>("shadowlab")};
    for (std::string& word : ended.words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);

    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
        ended.message = std::string("cannot start a program: ") + std::strerror(errno);
        return ended;
    }
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, pipe[1], 2);
    pid_t child = 0;
    const int failed = ::posix_spawn(&child, "/proc/self/exe", &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(pipe[1]);
    std::string said;
    if (!failed) {
        std::array<char, 4096> buffer{};
        for (ssize_t got = 0; (got = ::read(pipe[0], buffer.data(), buffer.size())) > 0;)
            said.append(buffer.data(), static_cast<std::size_t>(got));
        int status = 0;
        ::waitpid(child, &status, 0);
        ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    } else {
        said = std::string("cannot start a program: ") + std::strerror(failed);
    }
    ::close(pipe[0]);
    while (!said.empty() && said.back() == '\n')
        said.pop_back();
    ended.message = said.substr(said.rfind('\n') + 1);
    return ended;
}

} // namespace

void OwnProgram::start(std::vector<std::string> words) {
    running_.push_back(std::async(std::launch::async, run, std::move(words)));
}

std::optional<OwnProgram::Ended> OwnProgram::take() {
    for (auto one = running_.begin(); one != running_.end(); ++one) {
        if (one->wait_for(std::chrono::seconds(0)) != std::future_status::ready) continue;
        Ended ended = one->get();
        running_.erase(one);
        return ended;
    }
    return {};
}

} // namespace shadowlab::window
