// Control characters in names and broken UTF-8 are shown as \xNN, so that one message stays one line.
// SPDX-License-Identifier: MIT
#include "app/cli/messages.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_error.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::cli {

namespace {

constexpr std::size_t kLongestMessage = 2000; ///< bytes; a path may have 4096, too many to read

/// Something long is left out in the middle: a message begins with what is wrong, and ends with what to do.
std::string shortened(std::string_view sentence) {
    constexpr std::size_t kEnd = 400;
    if (sentence.size() <= kLongestMessage) return std::string(sentence);
    return std::string(sentence.substr(0, kLongestMessage - kEnd - 10)) + " [...] " +
           std::string(sentence.substr(sentence.size() - kEnd));
}

void say(const char* prefix, std::string_view sentence) {
    std::fprintf(stderr, "%s%s\n", prefix, scene::shown(shortened(sentence), kLongestMessage).c_str());
}

} // namespace

void keepStandardDescriptors() {
    // open() takes the lowest free number. Standard output is opened for reading: writing to it still fails, with
    // EBADF.
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(descriptor, F_GETFD) < 0 && errno == EBADF)
            ::open("/dev/null", descriptor == STDOUT_FILENO ? O_RDONLY : O_RDWR);
}

void print(std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(STDOUT_FILENO, text.data(), text.size());
        if (written >= 0) {
            text.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno == EPIPE) {
            return;
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) { // a pipe that its owner made non-blocking
            pollfd waiting{STDOUT_FILENO, POLLOUT, 0};
            ::poll(&waiting, 1, -1);
        } else if (errno != EINTR) {
            throw Error(ExitStatus::cannotWrite, image::outputErrorText("standard output", errno, false));
        }
    }
}

std::optional<std::size_t> terminalColumns() {
    if (!::isatty(STDOUT_FILENO)) return std::nullopt;
    constexpr std::size_t kUsual = 80;
    winsize size{};
    const bool isKnown = ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return isKnown ? size.ws_col : kUsual;
}

void note(std::string_view sentence) { say("shadowlab: note: ", sentence); }

void complain(std::string_view sentence) { say("shadowlab: ", sentence); }

} // namespace shadowlab::cli
