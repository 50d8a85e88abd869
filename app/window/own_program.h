// Runs this program again, beside the window, so that a saved picture has the same bytes as one that the command line writes.
// SPDX-License-Identifier: MIT
#pragma once
#include <future>
#include <optional>
#include <string>
#include <vector>

namespace shadowlab::window {

class OwnProgram {
public:
    struct Ended {
        std::vector<std::string> words;
        int status = 0;      ///< 0 if all went well
        std::string message; ///< the last line it said on standard error
    };
    /// Starts `shadowlab WORDS...`.
    void start(std::vector<std::string> words);
    [[nodiscard]] bool isRunning() const { return !running_.empty(); }
    /// One that has ended since the last call.
    std::optional<Ended> take();

private:
    std::vector<std::future<Ended>> running_;
};

} // namespace shadowlab::window
