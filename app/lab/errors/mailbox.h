// A place for one thing that passes from one thread to another: what comes later takes the place of what nobody fetched.
//
// Neither side ever waits. A lock would do as well, were it not for a thread that runs only when nobody else wants the
// processor: it can be put aside with the lock in its hand, and then the window would stand still with it.
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
    /// Nothing: nothing new has come.
    std::unique_ptr<Letter> take() { return exchange(nullptr); }

private:
    std::unique_ptr<Letter> exchange(Letter* letter) {
        return std::unique_ptr<Letter>(held_.exchange(letter, std::memory_order_acq_rel));
    }
    std::atomic<Letter*> held_ = nullptr;
};

} // namespace shadowlab::lab
