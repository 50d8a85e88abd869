// Where the layers of a map are drawn in a picture that shows all of them.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>

#include "techniques/shadow_map/fit/light_maps.h"

namespace shadowlab::shadow_map {

/// The six maps around a light are shown as a 3 x 2 sheet: +x +y +z above -x -y -z; cascades side by side, the nearest first.
struct Sheet {
    bool cube;
    ivec2 cells;
    int cellSize;
    Sheet(const LightMaps& maps, ivec2 within)
        : cube(maps.layout == Layout::cube), cells(cube ? ivec2(3, 2) : cellsOf(maps.layers())),
          cellSize(std::max(1, std::min(within.x / cells.x, within.y / cells.y))) {}
    /// Wide pictures have room for two maps beside each other, and below them for two more.
    static ivec2 cellsOf(int layers) { return layers < 2 ? ivec2(1) : layers == 2 ? ivec2(2, 1) : ivec2(2, 2); }
    [[nodiscard]] ivec2 size() const { return cells * cellSize; }
    /// Column, and row from the top.
    [[nodiscard]] ivec2 cellOf(int layer) const {
        return cube ? ivec2(layer / 2, layer % 2) : ivec2(layer % cells.x, layer / cells.x);
    }
    /// Where a place of a map is on the sheet: shares of its width and height from its upper left corner.
    [[nodiscard]] dvec2 shareOf(int layer, const dvec2& uv) const {
        return (dvec2(cellOf(layer)) + dvec2(uv.x, 1 - uv.y)) / dvec2(cells);
    }
    void setViewport(int layer) const {
        const ivec2 cell = cellOf(layer);
        const int x = cell.x * cellSize, y = (cells.y - 1 - cell.y) * cellSize;
        glViewport(x, y, cellSize, cellSize);
        glScissor(x, y, cellSize, cellSize);
        glEnable(GL_SCISSOR_TEST);
    }
};

} // namespace shadowlab::shadow_map
