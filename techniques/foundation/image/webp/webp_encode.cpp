// SPDX-License-Identifier: MIT
#include <webp/encode.h>

#include <memory>
#include <new>
#include <string>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/webp/webp.h"

namespace shadowlab::image {

namespace {

// Of photographs: at 82 of 100 no difference is seen beside the original at arm's length, and edges of shadows have no halo.
constexpr float kPhotoQuality = 82;
// Of photographs with letters: below 90 there is a haze around them.
constexpr float kLettersQuality = 92;
// libwebp's own middle; of exact pictures the quality is the effort as well.
constexpr int kEffort = 4;
constexpr float kExactEffort = 60;

struct Cleared {
    void operator()(WebPPicture* picture) const { WebPPictureFree(picture); }
};

} // namespace

std::vector<std::uint8_t> encodeWebp(const Image& image, WebpKind kind) {
    if (image.width > WEBP_MAX_DIMENSION || image.height > WEBP_MAX_DIMENSION)
        throw Error(ExitStatus::overLimit, "a WebP picture has at most " + std::to_string(WEBP_MAX_DIMENSION) + " pixels on a side");
    WebPConfig config;
    WebPPicture picture;
    if (!WebPConfigInit(&config) || !WebPPictureInit(&picture))
        throw Error(ExitStatus::bug, "libwebp is of another version than the one this program was built with");
    const std::unique_ptr<WebPPicture, Cleared> cleared(&picture);
    config.method = kEffort;
    if (kind == WebpKind::exact) {
        config.lossless = 1;
        config.exact = 1; // colours below transparent pixels stay what they are
        config.quality = kExactEffort;
        picture.use_argb = 1;
    } else {
        config.quality = kind == WebpKind::letters ? kLettersQuality : kPhotoQuality;
        config.use_sharp_yuv = 1; // edges of coloured things: half the resolution of colour is not seen in their brightness
    }
    WebPMemoryWriter writer;
    WebPMemoryWriterInit(&writer);
    const std::unique_ptr<WebPMemoryWriter, decltype(&WebPMemoryWriterClear)> freed(&writer, WebPMemoryWriterClear);
    picture.width = image.width;
    picture.height = image.height;
    picture.writer = WebPMemoryWrite;
    picture.custom_ptr = &writer;
    if (!WebPPictureImportRGBA(&picture, image.rgba.data(), image.width * static_cast<int>(kChannels))) throw std::bad_alloc();
    if (!WebPEncode(&config, &picture)) {
        if (picture.error_code == VP8_ENC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
        throw Error(ExitStatus::bug, "libwebp cannot write a picture (its error " + std::to_string(picture.error_code) + ")");
    }
    return {writer.mem, writer.mem + writer.size};
}

} // namespace shadowlab::image
