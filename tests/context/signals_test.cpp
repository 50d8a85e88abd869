// The first signal asks, and ends what does not listen; the second ends at once. No temporary stays behind.
// SPDX-License-Identifier: MIT
#include "app/context/signals.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>

#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"

namespace shadowlab::context {
namespace {

/// Signal handlers belong to a whole process, so each case has its own. Returns its exit status, less than 0 where a signal killed it.
int inChild(const std::function<int()>& action) {
    const pid_t child = ::fork();
    if (child == 0) {
        const rlimit noCore{0, 0};
        ::setrlimit(RLIMIT_CORE, &noCore);
        ::_exit(action());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

int afterOne(int signal) {
    return inChild([signal] {
        installSignalHandlers();
        if (interrupted()) return 1;
        throwIfInterrupted();
        std::raise(signal);
        try {
            throwIfInterrupted();
        } catch (const Interrupted& stop) {
            return interrupted() ? stop.exitStatus : 2;
        }
        return 0;
    });
}

TEST(Signals, FirstOneSetsTheFlag) {
    std::signal(SIGHUP, SIG_DFL); // also where these tests were started with nohup
    EXPECT_EQ(afterOne(SIGINT), 130);
    EXPECT_EQ(afterOne(SIGTERM), 143);
    EXPECT_EQ(afterOne(SIGHUP), 129);
    EXPECT_EQ(afterOne(SIGXCPU), 152);
    EXPECT_EQ(afterOne(SIGPIPE), 0);
    EXPECT_EQ(afterOne(SIGXFSZ), 0);
}

TEST(Signals, AClosedTerminalIsIgnoredWhereItIsFromTheStart) {
    std::signal(SIGHUP, SIG_IGN); // which is what nohup does
    EXPECT_EQ(afterOne(SIGHUP), 0);
    std::signal(SIGHUP, SIG_DFL);
}

TEST(Signals, SecondOneEndsAtOnceAndRemovesTemporaries) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / ("shadowlab_signals_" + std::to_string(::getpid()));
    fs::create_directory(folder);
    const int status = inChild([&] {
        installSignalHandlers();
        image::OutputFile file(folder / "a");
        file.write("half");
        std::raise(SIGINT);
        std::raise(SIGTERM);
        return 0;
    });
    EXPECT_EQ(status, 143);
    EXPECT_TRUE(fs::is_empty(folder));
    fs::remove_all(folder);
}

// Work that never asks is not waited for, and what it was writing does not stay half-written.
TEST(Signals, OneEndsWorkThatNeverAsks) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / ("shadowlab_alarm_" + std::to_string(::getpid()));
    fs::create_directory(folder);
    const int status = inChild([&] {
        installSignalHandlers();
        image::OutputFile file(folder / "a");
        file.write("half");
        std::raise(SIGTERM);
        constexpr unsigned kMuchLonger = 60; // seconds
        for (unsigned left = kMuchLonger; left > 0;)
            left = ::sleep(left);
        return 0;
    });
    EXPECT_EQ(status, 143);
    EXPECT_TRUE(fs::is_empty(folder));
    fs::remove_all(folder);
}

// What ends a program by default does so, and whatever was under way goes before: a file, and a folder with all that is in it.
TEST(Signals, OthersEndTheProgramAsEverAndLeaveNothing) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / ("shadowlab_quit_" + std::to_string(::getpid()));
    fs::create_directory(folder);
    for (const int signal : {SIGQUIT, SIGUSR1, SIGALRM}) {
        const int status = inChild([&] {
            installSignalHandlers();
            image::OutputFile file(folder / "a");
            file.write("half");
            const image::OutputFolder inner(folder / "b");
            fs::create_directories(inner.path() / "c" / "d");
            for (int i = 0; i < 300; ++i) // more than one call of the kernel lists
                std::ofstream(inner.path() / "c" / ("a-name-of-some-length-" + std::to_string(i))) << "whole";
            fs::create_symlink(folder.parent_path(), inner.path() / "link");
            std::raise(signal);
            return 0;
        });
        EXPECT_EQ(status, -signal);
        EXPECT_TRUE(fs::is_empty(folder)) << signal;
    }
    fs::remove_all(folder);
}

TEST(Signals, TheSecondOneRemovesFolders) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / ("shadowlab_folder_" + std::to_string(::getpid()));
    fs::create_directory(folder);
    const int status = inChild([&] {
        installSignalHandlers();
        const image::OutputFolder inner(folder / "b");
        image::writeWhole(inner.path() / "c", "whole");
        std::raise(SIGINT);
        std::raise(SIGINT);
        return 0;
    });
    EXPECT_EQ(status, 130);
    EXPECT_TRUE(fs::is_empty(folder));
    fs::remove_all(folder);
}

// Who starts a program may hold signals back; held back it would never end.
TEST(Signals, ThoseThatWereHeldBackArrive) {
    const int status = inChild([] {
        sigset_t held;
        sigemptyset(&held);
        for (const int signal : {SIGTERM, SIGALRM})
            sigaddset(&held, signal);
        ::sigprocmask(SIG_BLOCK, &held, nullptr);
        installSignalHandlers();
        std::raise(SIGTERM);
        return interrupted() ? 0 : 1;
    });
    EXPECT_EQ(status, 0);
}

} // namespace
} // namespace shadowlab::context
