// SPDX-License-Identifier: MIT
#include "app/student/grading/left_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/png/png.h"

namespace shadowlab::student {

namespace {

// A picture of a case, or of a search, has less than half a megabyte of pixels.
constexpr std::size_t kMostBytes = 4 << 20;

struct Descriptor {
    int value = -1;
    ~Descriptor() {
        if (value >= 0) ::close(value);
    }
};

} // namespace

std::optional<std::vector<std::uint8_t>> bytesLeftIn(const std::filesystem::path& file) {
    // Opened once, so that what is checked is what is read. Neither a link is followed, nor a pipe's writer waited for.
    const Descriptor opened{::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)};
    struct stat status {};
    if (opened.value < 0 || ::fstat(opened.value, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    if (static_cast<std::uintmax_t>(status.st_size) > kMostBytes) return std::nullopt;
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(status.st_size));
    std::size_t read = 0;
    while (read < bytes.size()) {
        const ssize_t got = ::read(opened.value, bytes.data() + read, bytes.size() - read);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return std::nullopt;
        if (got == 0) break; // it has become shorter
        read += static_cast<std::size_t>(got);
    }
    bytes.resize(read);
    return bytes;
}

std::optional<image::Image> pictureIn(std::span<const std::uint8_t> bytes) {
    try {
        return image::decodePng(bytes, "picture").image;
    } catch (const Error&) {
        return std::nullopt; // a plug-in that ends the program itself may leave half of a file
    }
}

std::optional<image::Image> pictureIn(std::span<const std::uint8_t> bytes, ivec2 size) {
    std::optional<image::Image> picture = pictureIn(bytes);
    if (picture && (picture->width != size.x || picture->height != size.y)) picture.reset();
    return picture;
}

} // namespace shadowlab::student
