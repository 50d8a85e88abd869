// SPDX-License-Identifier: MIT
#include "app/session/film.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

#include "app/session/film_encoder.h"
#include "techniques/foundation/image/output_file.h"

namespace shadowlab::session {

namespace {

class PngFilm final : public Film {
public:
    PngFilm(std::filesystem::path path, image::FrameTime time, std::vector<image::PngText> text)
        : path_(std::move(path)), time_(time), animation_(std::move(text)) {}

    void add(const image::Image& picture) override { animation_.add(picture, time_); }
    void finish() override { image::writeWhole(path_, animation_.finish()); }

private:
    std::filesystem::path path_;
    image::FrameTime time_;
    image::AnimatedPng animation_;
};

class Mp4Film final : public Film {
public:
    Mp4Film(std::filesystem::path path, image::FrameTime time)
        : path_(std::move(path)), time_(time), program_(requireFfmpeg(path_)) {}

    void add(const image::Image& picture) override {
        if (!encoder_) encoder_ = std::make_unique<FilmEncoder>(program_, picture.width, picture.height, time_);
        encoder_->add(picture);
    }
    void finish() override { image::writeWhole(path_, encoder_->finish()); }

private:
    std::filesystem::path path_;
    image::FrameTime time_;
    std::filesystem::path program_;
    std::unique_ptr<FilmEncoder> encoder_; ///< once the size of the pictures is known
};

} // namespace

bool isMp4(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".mp4";
}

std::unique_ptr<Film> makeFilm(const std::filesystem::path& path, image::FrameTime time,
                               std::vector<image::PngText> text) {
    image::probeWritable(path);
    if (isMp4(path)) return std::make_unique<Mp4Film>(path, time);
    return std::make_unique<PngFilm>(path, time, std::move(text));
}

} // namespace shadowlab::session
