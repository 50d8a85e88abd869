// Pictures as tiles: what comes out of a pack is what went in, and what was there before takes no room.
// SPDX-License-Identifier: MIT
#include "app/course/explore/picture_pack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "tests/support/webp_tiles.h"

namespace shadowlab::course {
namespace {

constexpr int kWidth = 200, kHeight = 150; ///< 4 x 3 tiles, of which those at the rim are cut off

/// Every pixel has a colour of its own.
image::Image colored(int width = kWidth, int height = kHeight) {
    image::Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.set(x, y, {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), static_cast<std::uint8_t>(x * y), 255});
    return image;
}

image::Image picture(const PicturePack& pack, int map, int width = kWidth, int height = kHeight) {
    std::vector<testing::TileSheet> sheets;
    for (const PicturePack::Sheet& sheet : pack.sheets())
        sheets.push_back({testing::decodedWebp(std::span(pack.bytes()).subspan(sheet.piece.offset, sheet.piece.length)), sheet.firstTile,
                          sheet.count, sheet.columns, sheet.border});
    std::vector<int> tiles;
    const PicturePack::Map& runs = pack.maps()[static_cast<std::size_t>(map)];
    for (std::size_t i = 0; i < runs.size(); i += 2)
        for (int k = 0; k < runs[i + 1]; ++k)
            tiles.push_back(runs[i] == PicturePack::kEmpty ? -1 : runs[i] + k);
    EXPECT_EQ(tiles.size(), static_cast<std::size_t>((width + kTileSide - 1) / kTileSide * ((height + kTileSide - 1) / kTileSide)));
    return testing::fromTiles({width, height}, kTileSide, tiles, sheets);
}

TEST(PicturePackTest, WhatIsExactComesOutAsItWentIn) {
    PicturePack pack;
    image::Image holes = colored();
    image::fillRect(holes, 20, 30, 40, 40, {0, 0, 0, 0});
    const int whole = pack.add(colored(), image::WebpKind::exact), with = pack.add(holes, image::WebpKind::exact);
    EXPECT_EQ(picture(pack, whole), colored());
    EXPECT_EQ(picture(pack, with), holes);
    for (const int side : {1, kTileSide - 1, kTileSide, kTileSide + 1}) {
        PicturePack small;
        EXPECT_EQ(picture(small, small.add(colored(side, side), image::WebpKind::exact), side, side), colored(side, side)) << side;
    }
}

TEST(PicturePackTest, OnlyTilesThatDifferAreStored) {
    PicturePack pack;
    const int first = pack.add(colored(), image::WebpKind::photo);
    ASSERT_EQ(pack.sheets().size(), 1u);
    EXPECT_EQ(pack.sheets()[0].count, 12);
    image::Image changed = colored();
    changed.set(70, 10, {1, 2, 3, 255}); // in the second tile
    const int second = pack.add(changed, image::WebpKind::photo);
    ASSERT_EQ(pack.sheets().size(), 2u);
    EXPECT_EQ(pack.sheets()[1].count, 1);
    EXPECT_EQ(pack.maps()[static_cast<std::size_t>(second)], (PicturePack::Map{0, 1, 12, 1, 2, 10}));
    EXPECT_EQ(pack.add(colored(), image::WebpKind::photo), first);
    EXPECT_EQ(pack.sheets().size(), 2u);
    // With loss and without it are two things.
    pack.add(colored(), image::WebpKind::exact);
    EXPECT_EQ(pack.sheets().size(), 3u);
}

/// Of two neighbouring tiles only those that have changed are stored, side by side with others: what is seen along their rims must be
/// no worse than within them. Without a border it was off by 48 of 255.
TEST(PicturePackTest, PhotographsHaveNoSeams) {
    image::Image stripes(256, 256), changed;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            stripes.set(x, y, y / 64 % 2 == 0 ? image::Color8{200, 40, 30, 255} : image::Color8{30, 60, 190, 255});
    changed = stripes;
    for (const ivec2 tile : {ivec2(0, 0), ivec2(1, 1), ivec2(2, 0), ivec2(3, 3)}) // in the sheet red stands beside blue
        image::fillRect(changed, tile.x * 64 + 20, tile.y * 64 + 20, 20, 20, {90, 200, 90, 255});
    PicturePack pack;
    pack.add(stripes, image::WebpKind::photo);
    const image::Image shown = picture(pack, pack.add(changed, image::WebpKind::photo), 256, 256);
    ASSERT_EQ(pack.sheets().size(), 2u);
    int worst = 0, compared = 0;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) {
            // Rims of tiles; within the picture red and blue meet there in rows, which are left out.
            if ((x % 64 != 0 && x % 64 != 63) || y % 64 < 4 || y % 64 > 59) continue;
            const image::Color8 a = shown.at(x, y), b = changed.at(x, y);
            worst = std::max({worst, std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
            ++compared;
        }
    EXPECT_GT(compared, 1500);
    EXPECT_LE(worst, 8) << "the loss of even ground at this quality is 3";
}

TEST(PicturePackTest, WhereThereIsNothingNothingIsStored) {
    PicturePack pack;
    const int empty = pack.add(image::Image(kWidth, kHeight, {9, 9, 9, 0}), image::WebpKind::exact);
    EXPECT_TRUE(pack.sheets().empty());
    EXPECT_EQ(pack.maps()[static_cast<std::size_t>(empty)], (PicturePack::Map{PicturePack::kEmpty, 12}));
}

TEST(PicturePackTest, EveryPieceBeginsWhereBase64Does) {
    PicturePack pack;
    for (std::size_t length = 1; length < 8; ++length) {
        const std::vector<std::uint8_t> bytes(length, static_cast<std::uint8_t>(length));
        const PicturePack::Piece piece = pack.addPiece(bytes);
        EXPECT_EQ(piece.offset % 3, 0u);
        EXPECT_EQ(piece.length, length);
        EXPECT_EQ(pack.bytes()[piece.offset], length);
    }
}

} // namespace
} // namespace shadowlab::course
