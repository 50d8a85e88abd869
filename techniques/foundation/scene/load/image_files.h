// The images that materials name, read within the limits: masks and colours.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string_view>
#include <utility>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/surface_color.h"

namespace shadowlab::scene {

struct Limits;

/// Makes of each file, and each way to read it, one mask or one image, however many materials name it.
class ImageFiles {
public:
    /// `limits.texels` is the number of texels that other images have taken. Throws Error (badInput, overLimit): "not a readable PNG:
    /// ...; save it again", without the file's name, which the caller knows as the user wrote it.
    std::shared_ptr<const AlphaMask> mask(const std::filesystem::path& canonical, const MaskChoice& choice, const Limits& limits);
    std::shared_ptr<const ColorImage> colors(const std::filesystem::path& canonical, const ImageGain& gain, const Limits& limits);

    /// A picture that lies in memory, to be asked for under a name that no file has. `bytes` must outlive this.
    void hold(const std::filesystem::path& name, std::string_view bytes) { held_[name] = bytes; }
    [[nodiscard]] bool holds(const std::filesystem::path& name) const { return held_.contains(name); }

private:
    template <typename Made, typename How>
    std::shared_ptr<const Made> made(std::map<std::pair<std::filesystem::path, How>, std::shared_ptr<const Made>>& known,
                                     const std::filesystem::path& canonical, const How& how, const Limits& limits);
    [[nodiscard]] image::PictureFile read(const std::filesystem::path& canonical, const Limits& limits) const;

    std::map<std::pair<std::filesystem::path, MaskChoice>, std::shared_ptr<const AlphaMask>> masks_;
    std::map<std::pair<std::filesystem::path, ImageGain>, std::shared_ptr<const ColorImage>> colors_;
    std::map<std::filesystem::path, Error> failed_; ///< the errors of files that cannot be read; many materials may name one
    std::map<std::filesystem::path, std::string_view> held_;
    std::uint64_t texels_ = 0;                      ///< of all that have been made
};

} // namespace shadowlab::scene
