// Pictures that follow each other, on their way into one file: an animated PNG, or an MP4 film.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <vector>

#include "techniques/foundation/image/png/animated_png.h"

namespace shadowlab::film {

class Film {
public:
    virtual ~Film() = default;
    Film() = default;
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    /// All pictures are of one size. Each stays for `units` times the film's unit of time, at least 1; as a fraction with the
    /// unit's denominator that has to be of 16 bits.
    virtual void add(const image::Image& picture, int units = 1) = 0;
    /// Writes the file, whole or not at all. Throws Error (cannotWrite).
    virtual void finish() = 0;
};

/// Does the name end as that of an MP4 film does? Else the file is an animated PNG.
bool isMp4(const std::filesystem::path& path);

/// `unit`: the time that a picture stays, or that is counted in where some stay longer. The texts go into an animated PNG; a film has none. Throws Error (cannotWrite) where the file
/// cannot be written, or a film is wanted and the program ffmpeg, which makes it, is not installed.
std::unique_ptr<Film> makeFilm(const std::filesystem::path& path, image::FrameTime unit,
                               std::vector<image::PngText> text);

} // namespace shadowlab::film
