// SPDX-License-Identifier: MIT
#include "app/picture/wrong_marks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace shadowlab::picture {

namespace {

constexpr int kLeastRadius = 2;           ///< a square of 5 pixels
constexpr double kRadiusShare = 1.0 / 360; ///< of the picture's height: 5 pixels of 720, 7 of 1080

// Close together is decided by how many of the pixels around one are wrong, in a square four times as wide as a mark. Lines of
// errors up to three pixels wide, on the edge of a shadow, are to become wider; a line of three through the whole square fills
// as many pixels as three of its rows. Stripes of acne fill more.
constexpr int kSquareOfMarks = 4, kMostRows = 3;

/// How many entries of a picture are set in any rectangle of it: sums from its upper left corner (Crow, 1984).
class Sums {
public:
    Sums(const std::vector<std::uint8_t>& set, ivec2 size)
        : size_(size), sums_(static_cast<std::size_t>(size.x + 1) * static_cast<std::size_t>(size.y + 1)) {
        for (int y = 0; y < size.y; ++y) {
            std::int32_t row = 0;
            for (int x = 0; x < size.x; ++x) {
                row += set[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x)];
                sums_[at(x + 1, y + 1)] = sums_[at(x + 1, y)] + row;
            }
        }
    }
    /// In the square of that radius around a pixel, as far as it lies in the picture.
    [[nodiscard]] std::int32_t around(int x, int y, int radius) const {
        const int left = std::max(0, x - radius), right = std::min(size_.x, x + radius + 1);
        const int top = std::max(0, y - radius), bottom = std::min(size_.y, y + radius + 1);
        return sums_[at(right, bottom)] - sums_[at(left, bottom)] - sums_[at(right, top)] + sums_[at(left, top)];
    }

private:
    [[nodiscard]] std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x + 1) + static_cast<std::size_t>(x);
    }
    ivec2 size_;
    std::vector<std::int32_t> sums_;
};

} // namespace

int wideMark(int height) {
    return 2 * std::max(kLeastRadius, static_cast<int>(std::lround(kRadiusShare * height))) + 1;
}

WrongMarks wrongMarks(const std::vector<std::uint8_t>& isWrong, ivec2 size, int width) {
    const auto index = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
    };
    WrongMarks marks;
    marks.owner.assign(isWrong.size(), WrongMarks::kNone);
    std::vector<ivec2> wrong;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            if (isWrong[index(x, y)]) {
                wrong.emplace_back(x, y);
                marks.owner[index(x, y)] = static_cast<std::int32_t>(index(x, y));
            }
    marks.single = static_cast<int>(wrong.size());
    if (width <= kOnePixel || wrong.empty()) return marks;

    const int square = kSquareOfMarks * width + 1;
    const Sums wrongSums(isWrong, size);
    std::vector<std::uint8_t> isDense(isWrong.size());
    for (const ivec2& pixel : wrong)
        isDense[index(pixel.x, pixel.y)] = wrongSums.around(pixel.x, pixel.y, square / 2) > kMostRows * square;
    // Beside a dense place a square would only make its edge ragged.
    const Sums denseSums(isDense, size);
    std::vector<ivec2> alone;
    std::ranges::copy_if(wrong, std::back_inserter(alone),
                         [&](const ivec2& pixel) { return denseSums.around(pixel.x, pixel.y, width) == 0; });
    marks.wide = static_cast<int>(alone.size());
    marks.single -= marks.wide;

    // The nearest places of all squares first: what a nearer pixel has taken stays its own.
    std::vector<ivec2> places;
    for (int y = -(width / 2); y <= width / 2; ++y)
        for (int x = -(width / 2); x <= width / 2; ++x)
            places.emplace_back(x, y);
    std::ranges::stable_sort(places, {}, [](const ivec2& place) { return place.x * place.x + place.y * place.y; });
    for (const ivec2& place : places)
        for (const ivec2& pixel : alone) {
            const int x = pixel.x + place.x, y = pixel.y + place.y;
            if (x < 0 || x >= size.x || y < 0 || y >= size.y || marks.owner[index(x, y)] != WrongMarks::kNone) continue;
            marks.owner[index(x, y)] = static_cast<std::int32_t>(index(pixel.x, pixel.y));
        }
    return marks;
}

std::string noteOf(const WrongMarks& marks, int width) {
    if (marks.wide == 0) return {};
    const std::string wide = "drawn " + std::to_string(width) + " pixels wide";
    return marks.single == 0 ? "each wrong pixel is " + wide
                             : "wrong pixels that stand alone are " + wide;
}

} // namespace shadowlab::picture
