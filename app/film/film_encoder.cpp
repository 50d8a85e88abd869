// SPDX-License-Identifier: MIT
#include "app/film/film_encoder.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <sstream>
#include <string>

#include "techniques/foundation/base/error.h"

extern char** environ;

namespace shadowlab::film {

namespace {

// Where the program finds the memory that it writes to.
constexpr int kFilmInChild = 3;

// A step that stays for two seconds is half a picture a second. Some players show nothing of what has so few: then each is
// repeated.
constexpr int kLeastRate = 5, kUsualRate = 25;

[[noreturn]] void fail(const std::string& what) {
    throw Error(ExitStatus::cannotWrite,
                "ffmpeg made no film: " + what + "; write an animated PNG instead (-o NAME.png)");
}

/// All that is in a file, from its beginning.
std::vector<std::uint8_t> contentOf(int descriptor) {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) fail(std::strerror(errno));
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(status.st_size));
    std::size_t filled = 0;
    while (filled < bytes.size()) {
        const ssize_t got =
            ::pread(descriptor, bytes.data() + filled, bytes.size() - filled, static_cast<off_t>(filled));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) break;
        filled += static_cast<std::size_t>(got);
    }
    bytes.resize(filled);
    return bytes;
}

std::string lastLine(const std::vector<std::uint8_t>& text) {
    std::istringstream lines(std::string(text.begin(), text.end()));
    std::string last;
    for (std::string line; std::getline(lines, line);)
        if (!line.empty()) last = line;
    return last;
}

/// The arguments of ffmpeg; `time` is that of each picture. One thread and no dates, so that the same pictures give the same film.
std::vector<std::string> words(int width, int height, image::FrameTime time) {
    const std::string rate = std::to_string(time.denominator) + "/" + std::to_string(time.numerator);
    const bool isSlow = time.denominator < kLeastRate * time.numerator;
    // Its colours are kept for every second pixel of a row and a column, so there have to be even numbers of them.
    std::string filters = "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv";
    if (isSlow) filters += ",fps=" + std::to_string(kUsualRate);
    std::istringstream all(
        "ffmpeg -hide_banner -loglevel error -nostdin"
        " -f rawvideo -pixel_format rgb24 -video_size " +
        std::to_string(width) + "x" + std::to_string(height) + " -framerate " + rate + " -i pipe:0 -vf " + filters +
        " -c:v libx264 -crf 16 -pix_fmt yuv420p -threads 1"
        " -colorspace bt709 -color_primaries bt709 -color_trc iec61966-2-1 -color_range tv"
        " -map_metadata -1 -fflags +bitexact -flags:v +bitexact -movflags +faststart -f mp4 -y file:/proc/self/fd/" +
        std::to_string(kFilmInChild));
    return {std::istream_iterator<std::string>(all), {}};
}

} // namespace

std::filesystem::path requireFfmpeg(const std::filesystem::path& film) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const std::filesystem::path program = std::filesystem::path(folder.empty() ? "." : folder) / "ffmpeg";
        std::error_code ignored;
        if (std::filesystem::is_regular_file(program, ignored) && ::access(program.c_str(), X_OK) == 0) return program;
    }
    throw Error(ExitStatus::cannotWrite, film.string() +
                                             ": MP4 films are made by the program ffmpeg, which is not installed; "
                                             "install the package ffmpeg, or write an animated PNG (-o " +
                                             film.stem().string() + ".png)");
}

void FilmEncoder::Descriptor::close() {
    if (value >= 0) ::close(value);
    value = -1;
}

FilmEncoder::FilmEncoder(const std::filesystem::path& program, int width, int height, image::FrameTime time) {
    film_.value = ::memfd_create("film", MFD_CLOEXEC);
    said_.value = ::memfd_create("what ffmpeg says", MFD_CLOEXEC);
    std::array<int, 2> pipe{-1, -1};
    if (film_.value < 0 || said_.value < 0 || ::pipe2(pipe.data(), O_CLOEXEC) != 0) fail(std::strerror(errno));
    Descriptor taken;
    taken.value = pipe[0];
    pictures_.value = pipe[1];
    std::vector<std::string> all = words(width, height, time);
    std::vector<char*> arguments;
    for (std::string& word : all)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    // Descriptors 0 to 2 are taken (messages.h, keepStandardDescriptors), so none of these is in the way of another but the
    // film's own place, which is filled last.
    posix_spawn_file_actions_adddup2(&actions, taken.value, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, said_.value, 2);
    posix_spawn_file_actions_adddup2(&actions, film_.value, kFilmInChild);
    // It must not inherit that closed pipes are ignored here.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t usual;
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    const int failed = ::posix_spawn(&process_, program.c_str(), &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (failed) {
        process_ = -1;
        fail(std::strerror(failed));
    }
}

FilmEncoder::~FilmEncoder() {
    if (process_ < 0) return;
    ::kill(process_, SIGKILL); // what it wrote has no name, and goes with it
    ::waitpid(process_, nullptr, 0);
}

void FilmEncoder::add(const image::Image& picture) {
    rgb_.clear();
    for (std::size_t i = 0; i < picture.rgba.size(); i += image::kChannels)
        rgb_.insert(rgb_.end(), {picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]});
    std::size_t written = 0;
    while (pictures_.value >= 0 && written < rgb_.size()) {
        const ssize_t taken = ::write(pictures_.value, rgb_.data() + written, rgb_.size() - written);
        if (taken < 0 && errno == EINTR) continue;
        if (taken < 0) pictures_.close(); // ffmpeg has ended: finish() reports why
        written += taken < 0 ? 0 : static_cast<std::size_t>(taken);
    }
}

std::vector<std::uint8_t> FilmEncoder::finish() {
    const bool tookAll = pictures_.value >= 0;
    pictures_.close();
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR)
        ;
    process_ = -1;
    std::vector<std::uint8_t> film = contentOf(film_.value);
    if (tookAll && WIFEXITED(status) && WEXITSTATUS(status) == 0 && !film.empty()) return film;
    const std::string said = lastLine(contentOf(said_.value));
    fail(!said.empty() ? said : "it ended without saying why");
}

} // namespace shadowlab::film
