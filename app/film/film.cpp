// SPDX-License-Identifier: MIT
#include "app/film/film.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

#include "app/film/film_encoder.h"
#include "techniques/foundation/image/output_file.h"

namespace shadowlab::film {

namespace {

class PngFilm final : public Film {
public:
    PngFilm(std::filesystem::path path, image::FrameTime unit, std::vector<image::PngText> text)
        : path_(std::move(path)), unit_(unit), animation_(std::move(text)) {}

    void add(const image::Image& picture, int units) override {
        animation_.add(picture, {static_cast<std::uint16_t>(units * unit_.numerator), unit_.denominator});
    }
    void finish() override { image::writeWhole(path_, animation_.finish()); }

private:
    std::filesystem::path path_;
    image::FrameTime unit_;
    image::AnimatedPng animation_;
};

class Mp4Film final : public Film {
public:
    Mp4Film(std::filesystem::path path, image::FrameTime unit)
        : path_(std::move(path)), unit_(unit), program_(requireFfmpeg(path_)) {}

    void add(const image::Image& picture, int units) override {
        if (!encoder_) encoder_ = std::make_unique<FilmEncoder>(program_, picture.width, picture.height, unit_);
        for (int i = 0; i < units; ++i)
            encoder_->add(picture);
    }
    void finish() override { image::writeWhole(path_, encoder_->finish()); }

private:
    std::filesystem::path path_;
    image::FrameTime unit_;
    std::filesystem::path program_;
    std::unique_ptr<FilmEncoder> encoder_; ///< once the size of the pictures is known
};

} // namespace

bool isMp4(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".mp4";
}

std::unique_ptr<Film> makeFilm(const std::filesystem::path& path, image::FrameTime unit,
                               std::vector<image::PngText> text) {
    image::probeWritable(path);
    if (isMp4(path)) return std::make_unique<Mp4Film>(path, unit);
    return std::make_unique<PngFilm>(path, unit, std::move(text));
}

} // namespace shadowlab::film
