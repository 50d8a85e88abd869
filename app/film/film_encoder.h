// Encodes a film with the program ffmpeg, which reads raw pictures from a pipe.
//
// ffmpeg writes into a memory file without a name (memfd), so that nothing is left of an unfinished film, however either program
// ends. H.264 in MP4, which every player and every slide program shows. The colour space is declared, because players guess otherwise.
// SPDX-License-Identifier: MIT
#pragma once
#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <vector>

#include "techniques/foundation/image/png/animated_png.h"

namespace shadowlab::film {

/// The program of that name in the folders of PATH. Throws Error (cannotWrite) that says what to install, if there is none;
/// `film` is the file that cannot be made then.
std::filesystem::path requireFfmpeg(const std::filesystem::path& film);

class FilmEncoder {
public:
    /// Starts the program. Throws Error (cannotWrite) where that fails.
    FilmEncoder(const std::filesystem::path& program, int width, int height, image::FrameTime time);
    /// Ends the program, if it is still running.
    ~FilmEncoder();
    FilmEncoder(const FilmEncoder&) = delete;
    FilmEncoder& operator=(const FilmEncoder&) = delete;

    /// Adds a picture of the size given before. If ffmpeg has failed, finish() reports it.
    void add(const image::Image& picture);
    /// The bytes of the film. Throws Error (cannotWrite) with the last line that the program said, if it failed.
    std::vector<std::uint8_t> finish();

private:
    /// A descriptor that is closed with its owner.
    struct Descriptor {
        int value = -1;
        Descriptor() = default;
        ~Descriptor() { close(); }
        Descriptor(const Descriptor&) = delete;
        Descriptor& operator=(const Descriptor&) = delete;
        void close();
    };

    Descriptor film_, said_, pictures_; ///< its output, its messages, and the pipe to it
    pid_t process_ = -1;
    std::vector<std::uint8_t> rgb_; ///< of one picture
};

} // namespace shadowlab::film
