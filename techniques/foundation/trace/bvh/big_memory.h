// Memory in large pages, for arrays that rays access at random.
//
// The TLB of a processor holds only some thousand pages. A tree of a million triangles takes 25 thousand pages of 4 KiB, so
// nearly every access to a node would be a TLB miss. So large arrays use pages of 2 MiB where the system has them (Linux,
// with madvise). New elements are not initialised, so that the caller can fill them on several threads.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <new>
#include <utility>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace shadowlab::trace {

template <typename T>
struct BigMemory {
    using value_type = T;
    static constexpr std::size_t kPage = std::size_t{2} << 20;

    BigMemory() = default;
    template <typename U>
    BigMemory(const BigMemory<U>&) {}

    /// Arrays smaller than a large page begin where T wants them to.
    static std::align_val_t alignment(std::size_t count) {
        return std::align_val_t{count * sizeof(T) >= kPage ? kPage : alignof(T)};
    }
    T* allocate(std::size_t count) {
        void* const memory = ::operator new(count * sizeof(T), alignment(count));
#if defined(__linux__)
        if (count * sizeof(T) >= kPage) (void)madvise(memory, count * sizeof(T), MADV_HUGEPAGE); // only a hint
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) { ::operator delete(memory, alignment(count)); }

    template <typename U>
    void construct(U* place) {
        ::new (static_cast<void*>(place)) U;
    }
    template <typename U, typename... Arguments>
    void construct(U* place, Arguments&&... arguments) {
        ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
    }
    friend bool operator==(const BigMemory&, const BigMemory&) { return true; }
};

/// A vector whose new elements are not set to anything.
template <typename T>
using BigVector = std::vector<T, BigMemory<T>>;

} // namespace shadowlab::trace
