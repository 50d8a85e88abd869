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

/// `unit`: how long a picture stays; a picture may also stay for several units. The texts go into an animated PNG; an MP4 film has
/// none. Throws Error (cannotWrite) where the file cannot be written, or where an MP4 film needs ffmpeg and it is not installed.
std::unique_ptr<Film> makeFilm(const std::filesystem::path& path, image::FrameTime unit,
                               std::vector<image::PngText> text);

} // namespace shadowlab::film
