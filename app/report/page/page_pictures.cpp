// SPDX-License-Identifier: MIT
#include "app/report/page/page_pictures.h"

#include <array>

#include "app/drawing/markup.h"

namespace shadowlab::report {

namespace {

constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::size_t kSizeAt = 16; ///< the header's width and height, four bytes each (PNG, ISO/IEC 15948)

/// {0, 0}: no PNG file.
glm::uvec2 sizeOf(const std::vector<std::uint8_t>& png) {
    if (png.size() < kSizeAt + 8 || !std::equal(kSignature.begin(), kSignature.end(), png.begin())) return {0, 0};
    glm::uvec2 size(0);
    for (std::size_t i = 0; i < 4; ++i) {
        size.x = size.x << 8 | png[kSizeAt + i];
        size.y = size.y << 8 | png[kSizeAt + 4 + i];
    }
    return size;
}

} // namespace

std::string Pictures::shown(const std::vector<std::uint8_t>& png, const std::string& alt) {
    const glm::uvec2 size = sizeOf(png);
    if (size.x == 0 || size.y == 0) return "<p>No picture was kept.</p>";
    const std::string width = std::to_string(size.x), height = std::to_string(size.y);
    const auto [place, isNew] = numbers_.emplace(png, numbers_.size() + 1);
    const std::string id = "picture" + std::to_string(place->second);
    if (isNew)
        definitions_ += "<image id=\"" + id + "\" width=\"" + width + "\" height=\"" + height +
                        "\" href=\"data:image/png;base64," + drawing::base64(png) + "\"/>\n";
    return "<svg viewBox=\"0 0 " + width + " " + height + "\" role=\"img\" aria-label=\"" +
           drawing::escapedMarkup(alt) + "\"><use href=\"#" + id + "\"/></svg>";
}

std::string Pictures::definitions() const {
    return "<svg class=\"store\" aria-hidden=\"true\"><defs>\n" + definitions_ + "</defs></svg>\n";
}

} // namespace shadowlab::report
