// The one exception type of the project: a sentence for the user and the exit status that goes with it.
// SPDX-License-Identifier: MIT
#pragma once
#include <stdexcept>
#include <string>

namespace shadowlab {

/// Documented exit statuses of the program.
enum class ExitStatus { ok = 0, usage = 2, badInput = 3, cannotWrite = 4, noContext = 5, overLimit = 6, bug = 70 };

/// Thrown for every fault that the user can fix. The message is one line of the form `FILE:LINE: what is wrong; what to do`
/// (without FILE:LINE where no file is involved).
class Error : public std::runtime_error {
public:
    Error(ExitStatus status, const std::string& message) : std::runtime_error(message), status_(status) {}
    [[nodiscard]] ExitStatus status() const { return status_; }

private:
    ExitStatus status_;
};

} // namespace shadowlab
