// One value per pixel.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

namespace shadowlab::judge {

template <typename Value>
struct Grid {
    int width = 0, height = 0;
    std::vector<Value> values; ///< rows from the top

    Grid() = default;
    Grid(int width, int height, Value fill = {})
        : width(width), height(height),
          values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {}
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] const Value& at(int x, int y) const { return values[index(x, y)]; }
    [[nodiscard]] Value& at(int x, int y) { return values[index(x, y)]; }
};

} // namespace shadowlab::judge
