// SPDX-License-Identifier: MIT
#include "app/foreign/export/plain_images.h"

#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/surface_color.h"

namespace shadowlab::foreign {

namespace {

/// Where both count, the size at which every texel of the mask has a whole number of pixels, and the colours as many as they can.
ivec2 commonSize(const scene::ColorImage* colors, const scene::AlphaMask* holes) {
    if (holes == nullptr) return colors->size();
    if (colors == nullptr) return holes->size();
    const ivec2 c = colors->size(), h = holes->size();
    return c.x % h.x == 0 && c.y % h.y == 0 ? c : h;
}

image::Image picture(const scene::ColorImage* colors, const scene::AlphaMask* holes) {
    const ivec2 size = commonSize(colors, holes);
    image::Image image(size.x, size.y, {255, 255, 255, 255});
    for (int row = 0; row < size.y; ++row)
        for (int x = 0; x < size.x; ++x) {
            const int y = size.y - 1 - row; // both count rows from the bottom
            const dvec2 place((x + 0.5) / size.x, (y + 0.5) / size.y);
            image::Color8 texel{255, 255, 255, 255};
            if (colors != nullptr && colors->size() == size) {
                const std::uint8_t* at = colors->texels().data() + image.offset(x, y);
                texel = {at[0], at[1], at[2], 255};
            } else if (colors != nullptr) {
                texel = image::encoded(colors->at(place, true));
            }
            if (holes != nullptr && holes->isHole(place, true)) texel.a = 0;
            image.set(x, row, texel);
        }
    return image;
}

} // namespace

int PlainImages::add(const std::shared_ptr<const scene::ColorImage>& colors, const std::shared_ptr<const scene::AlphaMask>& holes) {
    const auto [entry, isNew] = known_.try_emplace({colors.get(), holes.get()}, static_cast<int>(images_.size()));
    if (isNew) images_.push_back({"textures/" + std::to_string(images_.size() + 1) + ".png", picture(colors.get(), holes.get())});
    return entry->second;
}

} // namespace shadowlab::foreign
