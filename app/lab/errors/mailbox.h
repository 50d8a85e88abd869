// A place for one value that is passed from one thread to another. A later value replaces one that was not fetched.
//
// Neither side ever blocks. A mutex would not do: a thread of low priority may be preempted while it holds the mutex, and the thread
// that draws would then wait for it (priority inversion).
// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <memory>

namespace shadowlab::lab {

template <typename Letter>
class Mailbox {
public:
    Mailbox() = default;
    Mailbox(const Mailbox&) = delete;
    Mailbox& operator=(const Mailbox&) = delete;
    ~Mailbox() { take(); }

    void put(std::unique_ptr<Letter> letter) { exchange(letter.release()); }
    /// The newest value; nothing when none has come since the last call.
    std::unique_ptr<Letter> take() { return exchange(nullptr); }

private:
    std::unique_ptr<Letter> exchange(Letter* letter) {
        return std::unique_ptr<Letter>(held_.exchange(letter, std::memory_order_acq_rel));
    }
    std::atomic<Letter*> held_ = nullptr;
};

} // namespace shadowlab::lab
