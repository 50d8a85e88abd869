// Many pictures of one size in little room. Each is cut into tiles; a tile that occurred before is not stored again, as where a lamp
// moves and the background stays, or where two techniques differ along the shadows' edges alone. The new tiles of a picture are one
// WebP picture, a sheet. A picture is then a list of tiles: a map.
//
// Sheets, and other pieces, stand one after another in one run of bytes. Each begins at a multiple of three, so that of the base64 of
// all a reader can take the part that is the piece's own.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "techniques/foundation/image/image.h"
#include "techniques/foundation/image/webp/webp.h"

namespace shadowlab::course {

/// Pixels, a multiple of the 16 that WebP's blocks have: small enough that a shadow's edge leaves most of them as they are.
constexpr int kTileSide = 64;
/// Around each tile of a photograph its sheet holds so many pixels more of the picture. WebP predicts blocks from their neighbours, smooths
/// their edges, and has colours at half the resolution: without them a tile would show what stands beside it in the sheet.
constexpr int kPhotoBorder = 8;

class PicturePack {
public:
    struct Piece {
        std::size_t offset = 0, length = 0; ///< bytes
    };
    /// `count` tiles, numbered on from `firstTile`, in rows of `columns`, each with `border` pixels around it.
    struct Sheet {
        Piece piece;
        int firstTile = 0, count = 0, columns = 0, border = 0;
    };
    /// Runs of consecutive tiles, row by row: number of the first, how many. kEmpty: of tiles without any pixel.
    using Map = std::vector<int>;
    static constexpr int kEmpty = -1;

    /// The number of its map. Tiles at the right and lower rim end with the picture. Fully transparent pixels have no colour.
    int add(const image::Image& picture, image::WebpKind kind);
    /// Bytes of any kind.
    Piece addPiece(std::span<const std::uint8_t> bytes);

    [[nodiscard]] const std::vector<Sheet>& sheets() const { return sheets_; }
    [[nodiscard]] const std::vector<Map>& maps() const { return maps_; }
    [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

private:
    std::vector<std::uint8_t> bytes_;
    std::vector<Sheet> sheets_;
    std::vector<Map> maps_;
    std::map<Map, int> numbersOfMaps_;
    std::map<std::string, int> tiles_; ///< by digest: 64 bits, so that among 100,000 tiles two are taken for one once in 10^9 packs
    int nextTile_ = 0;
};

/// The tiles of a picture at some places, counted row by row, as a sheet of add() has them.
image::Image sheetOf(const image::Image& picture, std::span<const int> places, int columns, int border);

} // namespace shadowlab::course
