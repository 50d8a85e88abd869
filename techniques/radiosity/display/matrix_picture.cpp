// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/stages.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/base/look.h"

namespace shadowlab::radiosity {

namespace {

// From 1e-5 upward; smaller form factors have the darkest colour.
constexpr double kDecades = 5;

vec3 colorOf(double formFactor) {
    if (!(formFactor > 0)) return look::kNoSurface;
    return look::colorAt(look::viridis(), glm::clamp(1 + std::log10(formFactor) / kDecades, 0.0, 1.0));
}

const vec3 kPaper = look::linearFromSrgb8(0x24, 0x24, 0x28);
const vec3& kBar = look::kPatchJ; // row j
const vec3 kOne = look::linearFromSrgb8(0xF2, 0xF2, 0xF2);

/// The range of rows or columns that a pixel covers: at least one.
std::pair<std::size_t, std::size_t> covered(int pixel, int pixels, std::size_t count) {
    const auto at = [&](int p) {
        return static_cast<std::size_t>(static_cast<double>(p) * static_cast<double>(count) / pixels);
    };
    const std::size_t first = std::min(at(pixel), count - 1);
    return {first, std::max(first + 1, std::min(at(pixel + 1), count))};
}

/// The layout of the picture, in pixels.
struct Layout {
    ivec2 size;
    int margin, left, side;  ///< of the square matrix
    int barsLeft, unitWidth; ///< where the bars begin, and the length of a bar of 1
    /// On the left of the matrix there is room for the key. A narrow picture, whose key stands below it, is filled by the matrix.
    explicit Layout(ivec2 size)
        : size(size), margin(std::max(1, size.y / 24)), left(isNarrow(size) ? margin : size.x / 4),
          side(std::max(1, std::min(size.y - 2 * margin, isNarrow(size) ? size.x * 5 / 8 : size.x / 2))), barsLeft(left + side + margin),
          unitWidth(std::max(1, (size.x - barsLeft - margin) * 4 / 5)) {}
    static bool isNarrow(ivec2 size) { return 9 * size.x < 16 * size.y; }
};

} // namespace

void publishMatrix(Frame& frame, const PreparedExchange& exchange) {
    const Layout layout(frame.view().size);
    const std::size_t count = exchange.areas.size();
    std::vector<vec4> texels(static_cast<std::size_t>(layout.size.x) * static_cast<std::size_t>(layout.size.y),
                             vec4(kPaper, 1.0f));
    const auto texel = [&](int x, int yFromTop) -> vec4& {
        return texels[static_cast<std::size_t>(layout.size.y - 1 - yFromTop) * static_cast<std::size_t>(layout.size.x) +
                      static_cast<std::size_t>(x)];
    };
    for (int y = 0; y < layout.side && count > 0 && layout.margin + y < layout.size.y; ++y) {
        const auto [firstRow, endRow] = covered(y, layout.side, count);
        for (int x = 0; x < layout.side && layout.left + x < layout.size.x; ++x) {
            const auto [firstColumn, endColumn] = covered(x, layout.side, count);
            double sum = 0;
            for (std::size_t j = firstRow; j < endRow; ++j)
                for (std::size_t k = firstColumn; k < endColumn; ++k)
                    sum += exchange.matrix(j, k) / exchange.areas[j];
            const double mean = sum / static_cast<double>((endRow - firstRow) * (endColumn - firstColumn));
            texel(layout.left + x, layout.margin + y) = vec4(colorOf(mean), 1.0f);
        }
        double rowSum = 0;
        for (std::size_t j = firstRow; j < endRow; ++j)
            rowSum += exchange.rowSums[j] / static_cast<double>(endRow - firstRow);
        const int length = static_cast<int>(std::lround(rowSum * layout.unitWidth));
        for (int x = 0; x < length && layout.barsLeft + x < layout.size.x; ++x)
            texel(layout.barsLeft + x, layout.margin + y) = vec4(kBar, 1.0f);
        if (const int one = layout.barsLeft + layout.unitWidth; one < layout.size.x)
            texel(one, layout.margin + y) = vec4(kOne, 1.0f);
    }
    gl::Texture2D texture(GL_RGBA16F, layout.size, "matrix");
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, layout.size.x, layout.size.y, GL_RGBA, GL_FLOAT, texels.data());
    frame.publish("matrix", kNoLight, std::move(texture),
                  {.unit = "",
                   .key = {{colorOf(1), "F_jk = 1"},
                           {colorOf(1e-1), "0.1"},
                           {colorOf(1e-2), "0.01"},
                           {colorOf(1e-3), "0.001"},
                           {colorOf(1e-4), "0.0001"},
                           {colorOf(0), "0: j does not see k"},
                           {kBar, "sum of row j (line: 1)"}}});
}

} // namespace shadowlab::radiosity
