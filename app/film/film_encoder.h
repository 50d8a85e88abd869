// The program ffmpeg, which is given raw pictures and makes a film of them.
//
// What it writes goes into memory that has no name, so that nothing is left of a film that was not finished, whatever ends
// either program. H.264 in MP4, which every player and every slide program shows; the colours are declared, for players guess.
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

    /// The picture has the size that was said. A program that takes no more is heard of in finish().
    void add(const image::Image& picture);
    /// The bytes of the film. Throws Error (cannotWrite) with the last line that the program said, where it failed.
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

    Descriptor film_, said_, pictures_; ///< what it writes, what it says, and the pipe to it
    pid_t process_ = -1;
    std::vector<std::uint8_t> rgb_; ///< of one picture
};

} // namespace shadowlab::film
