// The images of materials, colour and holes in one picture, as most formats want them.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <vector>

#include "app/foreign/export/plain_scene.h"

namespace shadowlab::foreign {

/// Collects the images that parts of meshes use, each once.
class PlainImages {
public:
    /// Index of the picture of that colour image, that mask, or both; either may be null, but not both.
    int add(const std::shared_ptr<const scene::ColorImage>& colors, const std::shared_ptr<const scene::AlphaMask>& holes);
    [[nodiscard]] std::vector<PlainImage> take() { return std::move(images_); }

private:
    std::map<std::pair<const scene::ColorImage*, const scene::AlphaMask*>, int> known_;
    std::vector<PlainImage> images_;
};

} // namespace shadowlab::foreign
