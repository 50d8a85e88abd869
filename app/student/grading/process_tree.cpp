// SPDX-License-Identifier: MIT
#include "app/student/grading/process_tree.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace shadowlab::student {

namespace {

namespace fs = std::filesystem;

std::uint64_t residentBytes(pid_t process) {
    std::ifstream statm("/proc/" + std::to_string(process) + "/statm");
    std::uint64_t all = 0, resident = 0;
    statm >> all >> resident;
    return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

// Of a tree that grows while it is looked at, no more than this is followed: it is over every limit anyway.
constexpr std::size_t kMostFollowed = 4096;

} // namespace

std::vector<pid_t> childrenOf(pid_t process) {
    std::vector<pid_t> children;
    std::error_code gone; // it may end at any time
    for (fs::directory_iterator task("/proc/" + std::to_string(process) + "/task", gone), end; !gone && task != end;
         task.increment(gone)) {
        std::ifstream list(task->path() / "children");
        for (pid_t child = 0; list >> child;)
            children.push_back(child);
    }
    return children;
}

TreeUse useOf(pid_t process) {
    TreeUse use;
    std::vector<pid_t> all{process};
    for (std::size_t i = 0; i < all.size() && all.size() < kMostFollowed; ++i)
        for (const pid_t child : childrenOf(all[i]))
            all.push_back(child);
    for (const pid_t one : all)
        use.residentBytes += residentBytes(one);
    use.processes = static_cast<int>(all.size());
    return use;
}

void adoptOrphans() { ::prctl(PR_SET_CHILD_SUBREAPER, 1); }

void keepMemoryToItself() { ::prctl(PR_SET_DUMPABLE, 0); }

void endChildrenBut(const std::vector<pid_t>& kept) {
    for (;;) {
        bool any = false;
        for (const pid_t child : childrenOf(::getpid())) {
            if (std::ranges::find(kept, child) != kept.end()) continue;
            any = true;
            ::kill(child, SIGKILL);
            while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
            }
        }
        if (!any) return; // whose parent was ended just now has become a child of ours
    }
}

} // namespace shadowlab::student
