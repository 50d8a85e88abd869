// Pictures as tiles: what comes out of a pack is what went in, and what was there before takes no room.
// SPDX-License-Identifier: MIT
#include "app/course/explore/picture_pack.h"

#include <gtest/gtest.h>
#include <webp/decode.h>

#include <algorithm>

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

image::Image decoded(const PicturePack& pack, const PicturePack::Sheet& sheet) {
    int width = 0, height = 0;
    std::uint8_t* const pixels = WebPDecodeRGBA(pack.bytes().data() + sheet.piece.offset, sheet.piece.length, &width, &height);
    if (!pixels) throw std::runtime_error("no WebP");
    image::Image image(width, height);
    std::copy_n(pixels, image.rgba.size(), image.rgba.begin());
    WebPFree(pixels);
    return image;
}

image::Image picture(const PicturePack& pack, int map, int width = kWidth, int height = kHeight) {
    image::Image whole(width, height);
    const int across = (width + kTileSide - 1) / kTileSide;
    int place = 0;
    const PicturePack::Map& runs = pack.maps()[static_cast<std::size_t>(map)];
    for (std::size_t i = 0; i < runs.size(); i += 2)
        for (int k = 0; k < runs[i + 1]; ++k, ++place)
            for (const PicturePack::Sheet& sheet : pack.sheets()) {
                const int number = runs[i] + k - sheet.firstTile;
                if (runs[i] == PicturePack::kEmpty || number < 0 || number >= sheet.count) continue;
                image::Image tile(kTileSide, kTileSide);
                image::blit(tile, -(number % sheet.columns) * kTileSide, -(number / sheet.columns) * kTileSide, decoded(pack, sheet));
                image::blit(whole, place % across * kTileSide, place / across * kTileSide, tile);
            }
    EXPECT_EQ(place, across * ((height + kTileSide - 1) / kTileSide));
    return whole;
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
