// SPDX-License-Identifier: MIT
#include <turbojpeg.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <string>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/jpeg/jpeg.h"

namespace shadowlab::image {

namespace {

struct Destroy {
    void operator()(void* decoder) const { tjDestroy(decoder); }
};
using Decoder = std::unique_ptr<void, Destroy>;

[[noreturn]] void badJpeg(std::string_view name, const std::string& why) {
    throw Error(ExitStatus::badInput, std::string(name) + ": not a readable JPEG: " + why + "; save it again");
}

Decoder makeDecoder() {
    Decoder decoder(tjInitDecompress());
    if (!decoder) throw std::bad_alloc();
    return decoder;
}

PngSize judgedSize(tjhandle decoder, std::span<const std::uint8_t> bytes, std::string_view name, const PngLimits& limits) {
    if (!startsLikeJpeg(bytes)) badJpeg(name, "it does not start like one");
    int width = 0, height = 0, subsampling = 0, colors = 0;
    if (tjDecompressHeader3(decoder, bytes.data(), bytes.size(), &width, &height, &subsampling, &colors) != 0)
        badJpeg(name, tjGetErrorStr2(decoder));
    if (colors == TJCS_CMYK || colors == TJCS_YCCK) // made for a printer: which red its inks give, the file does not say
        badJpeg(name, "its colours are those of printing inks (CMYK), and RGB is needed");
    const PngSize size{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
    if (size.width > limits.side || size.height > limits.side)
        throw Error(ExitStatus::overLimit, std::string(name) + ": " + std::to_string(width) + " x " + std::to_string(height) +
                                               " pixels are more than the limit of " + std::to_string(limits.side) +
                                               " a side; scale it down");
    return size;
}

} // namespace

bool startsLikeJpeg(std::span<const std::uint8_t> bytes) {
    constexpr std::array<std::uint8_t, 3> kStart{0xff, 0xd8, 0xff}; // start of image, and of the next marker
    return bytes.size() >= kStart.size() && std::equal(kStart.begin(), kStart.end(), bytes.begin());
}

PngSize jpegSize(std::span<const std::uint8_t> bytes, std::string_view name, const PngLimits& limits) {
    return judgedSize(makeDecoder().get(), bytes, name, limits);
}

Image decodeJpeg(std::span<const std::uint8_t> bytes, std::string_view name, const PngLimits& limits) {
    const Decoder decoder = makeDecoder();
    const auto [width, height] = judgedSize(decoder.get(), bytes, name, limits);
    Image image(static_cast<int>(width), static_cast<int>(height));
    // The accurate transform: the fast one differs by a level or two. A warning (an early end, a damaged block) is a fault here. A
    // scan limit: some kilobytes of a progressive file may ask for the same blocks thousands of times.
    constexpr int kFlags = TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS;
    if (tjDecompress2(decoder.get(), bytes.data(), bytes.size(), image.rgba.data(), image.width, 0, image.height, TJPF_RGBA, kFlags) != 0)
        badJpeg(name, tjGetErrorStr2(decoder.get()));
    return image;
}

} // namespace shadowlab::image
