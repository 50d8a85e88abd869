// Where the system refuses threads, llvmpipe is made to draw without them; elsewhere nothing changes.
// SPDX-License-Identifier: MIT
#include "app/context/mesa.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace shadowlab::context {
namespace {

/// More than the C library keeps stacks of for later: those need no addresses any more.
constexpr int kMany = 32;

/// What LP_NUM_THREADS, which asks for many, says afterwards, in a process of its own: it is looked at once. A stack needs addresses,
/// so a limit of these refuses threads, also to root.
int threadsAsked(bool refused) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::setenv("LP_NUM_THREADS", std::to_string(kMany).c_str(), 1);
        long pages = 0;
        if (std::FILE* file = std::fopen("/proc/self/statm", "r"); file && std::fscanf(file, "%ld", &pages) == 1)
            std::fclose(file);
        constexpr rlim_t kLessThanAStack = 2 << 20;
        const rlimit addresses{static_cast<rlim_t>(pages * ::sysconf(_SC_PAGESIZE)) + kLessThanAStack, RLIM_INFINITY};
        if (refused && (pages == 0 || ::setrlimit(RLIMIT_AS, &addresses) != 0)) ::_exit(100);
        doWithoutRefusedThreads();
        const char* given = std::getenv("LP_NUM_THREADS");
        ::_exit(given ? std::atoi(given) : 101);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(MesaThreads, AreDoneWithoutWhereTheyAreRefused) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer ends the program where addresses are refused";
#endif
    EXPECT_EQ(threadsAsked(true), 0);
}

TEST(MesaThreads, AreNotTouchedWhereTheyAreGiven) { EXPECT_EQ(threadsAsked(false), kMany); }

} // namespace
} // namespace shadowlab::context
