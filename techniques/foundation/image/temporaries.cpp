// A signal handler must not allocate or lock. So the list has a fixed number of places, each guarded by a lock-free atomic,
// and is walked with system calls only.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/temporaries.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstring>

namespace shadowlab::image {
namespace {

enum PlaceState { kFree, kClaimed, kLive };
struct Place {
    std::atomic<int> state{kFree};
    char path[PATH_MAX];
};
constexpr std::size_t kPlaces = 32; // outputs under way at one time; the program has one or two
std::array<Place, kPlaces> places;
static_assert(std::atomic<int>::is_always_lock_free);

/// As the kernel writes them (getdents64(2)); readdir() may allocate.
struct Entry {
    ino64_t inode;
    off64_t next;
    unsigned short bytes;
    unsigned char type;
    char name[256];
};

/// A file, or a folder and all that is in it; links are not followed. Our folders are a few levels deep.
void removeTree(int folder, const char* name, int levels) noexcept {
    if (::unlinkat(folder, name, 0) == 0 || levels == 0) return;
    const int inner = ::openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (inner < 0) return;
    alignas(Entry) std::array<char, 4096> buffer;
    for (long got; (got = ::syscall(SYS_getdents64, inner, buffer.data(), buffer.size())) > 0;)
        for (long at = 0; at < got;) {
            const auto* entry = reinterpret_cast<const Entry*>(buffer.data() + at);
            at += entry->bytes;
            if (std::strcmp(entry->name, ".") != 0 && std::strcmp(entry->name, "..") != 0)
                removeTree(inner, entry->name, levels - 1);
        }
    ::close(inner);
    ::unlinkat(folder, name, AT_REMOVEDIR);
}

} // namespace

void ListedTemporary::list(const std::string& path) {
    strike();
    if (path.size() >= PATH_MAX) return;
    for (std::size_t i = 0; i < kPlaces; ++i) {
        int expected = kFree;
        if (!places[i].state.compare_exchange_strong(expected, kClaimed)) continue;
        std::memcpy(places[i].path, path.c_str(), path.size() + 1);
        places[i].state.store(kLive);
        place_ = static_cast<int>(i);
        return;
    }
}

void ListedTemporary::strike() {
    if (place_ >= 0) places[static_cast<std::size_t>(place_)].state.store(kFree);
    place_ = -1;
}

void removeTemporariesNow() noexcept {
    constexpr int kLevels = 16;
    for (Place& place : places)
        if (place.state.load() == kLive) removeTree(AT_FDCWD, place.path, kLevels);
}

} // namespace shadowlab::image
