// The first signal asks, the second ends at once and leaves no temporary behind.
// SPDX-License-Identifier: MIT
#include "app/context/signals.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <functional>

#include "techniques/foundation/image/output_file.h"

namespace shadowlab::context {
namespace {

/// Signal handlers belong to a whole process, so each case has its own. Returns its exit status, -1 if it was killed.
int inChild(const std::function<int()>& action) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(action());
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
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
    EXPECT_EQ(afterOne(SIGINT), 130);
    EXPECT_EQ(afterOne(SIGTERM), 143);
    EXPECT_EQ(afterOne(SIGPIPE), 0);
    EXPECT_EQ(afterOne(SIGXFSZ), 0);
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

} // namespace
} // namespace shadowlab::context
