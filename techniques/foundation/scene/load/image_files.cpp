// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/load/image_files.h"

#include <span>
#include <string>
#include <string_view>

#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::scene {

namespace {

/// Reads an image without a name; removes the colon after the empty name from an error message.
template <typename Read>
auto nameless(const Read& read) {
    try {
        return read();
    } catch (const Error& error) {
        constexpr std::size_t kAfterColon = 2; // ": not a readable PNG ..."
        throw Error(error.status(),
                    std::string(error.what()).substr(kAfterColon) +
                        (error.status() == ExitStatus::overLimit ? ", or set --limit image-side=VALUE" : ""));
    }
}

/// Before anything is allocated for the pixels. A file of some kilobytes may unpack to gigabytes.
void requireMemoryFor(const image::PngSize& size, std::uint64_t fileBytes, const Limits& limits) {
    const std::uint64_t texels = std::uint64_t{size.width} * size.height;
    if (const std::uint64_t needed = memoryForImage(texels, fileBytes, limits); needed > limits.memoryBytes)
        throw Error(ExitStatus::overLimit, std::to_string(size.width) + " x " + std::to_string(size.height) +
                                               " pixels, for which " + beyondMemory(needed, limits.memoryBytes) +
                                               "; scale it down, or set --limit memory=VALUE");
}

} // namespace

std::shared_ptr<const AlphaMask> ImageFiles::mask(const std::filesystem::path& canonical, const MaskChoice& choice,
                                                  const Limits& limits) {
    return made(masks_, canonical, choice, limits);
}

std::shared_ptr<const ColorImage> ImageFiles::colors(const std::filesystem::path& canonical, const ImageGain& gain,
                                                     const Limits& limits) {
    return made(colors_, canonical, gain, limits);
}

template <typename Made, typename How>
std::shared_ptr<const Made>
ImageFiles::made(std::map<std::pair<std::filesystem::path, How>, std::shared_ptr<const Made>>& known,
                 const std::filesystem::path& canonical, const How& how, const Limits& limits) {
    const std::pair key(canonical, how);
    if (const auto found = known.find(key); found != known.end()) return found->second;
    if (const auto found = failed_.find(canonical); found != failed_.end()) throw found->second;
    if (!held_.contains(canonical)) image::keepInput(canonical); // also if it cannot be read: it is still an input
    try {
        const image::PictureFile picture = read(canonical, limits);
        std::shared_ptr<const Made> result;
        if constexpr (std::is_same_v<Made, AlphaMask>)
            result = std::make_shared<const Made>(picture, how);
        else
            result = std::make_shared<const Made>(picture.image, how);
        texels_ += static_cast<std::uint64_t>(result->size().x) * static_cast<std::uint64_t>(result->size().y);
        return known[key] = result;
    } catch (const Error& error) {
        failed_.emplace(canonical, error);
        throw;
    }
}

image::PictureFile ImageFiles::read(const std::filesystem::path& canonical, const Limits& limits) const {
    const auto held = held_.find(canonical);
    const std::string file = held != held_.end() ? std::string() : readFile(canonical, limits.imageFileBytes, "image-file");
    const std::string_view text = held != held_.end() ? held->second : file;
    const std::span bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    const image::PngLimits pictureLimits{.side = limits.imageSide, .fileBytes = limits.imageFileBytes, .withTexts = false};
    constexpr std::string_view kNoName;
    Limits soFar = limits;
    soFar.texels += texels_;
    requireMemoryFor(nameless([&] { return image::pictureSize(bytes, kNoName, pictureLimits); }), bytes.size(), soFar);
    return nameless([&] { return image::pictureFrom(bytes, kNoName, pictureLimits); });
}

} // namespace shadowlab::scene
