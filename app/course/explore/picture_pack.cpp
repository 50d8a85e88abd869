// SPDX-License-Identifier: MIT
#include "app/course/explore/picture_pack.h"

#include <algorithm>

#include "app/picture/digest.h"

namespace shadowlab::course {

namespace {

int tilesAcross(int pixels) { return (pixels + kTileSide - 1) / kTileSide; }

/// The tile at a place, counted row by row. What lies beyond the picture is transparent.
image::Image tileOf(const image::Image& picture, int place) {
    const int columns = tilesAcross(picture.width);
    image::Image tile(kTileSide, kTileSide);
    image::blit(tile, -(place % columns) * kTileSide, -(place / columns) * kTileSide, picture);
    for (std::size_t i = 0; i < tile.rgba.size(); i += image::kChannels)
        if (tile.rgba[i + 3] == 0) std::fill_n(tile.rgba.begin() + static_cast<std::ptrdiff_t>(i), 3, std::uint8_t{0});
    return tile;
}

bool isEmpty(const image::Image& tile) {
    for (std::size_t i = 3; i < tile.rgba.size(); i += image::kChannels)
        if (tile.rgba[i] != 0) return false;
    return true;
}

void appendRun(PicturePack::Map& map, int tile) {
    const bool goesOn = !map.empty() && (tile == PicturePack::kEmpty ? map[map.size() - 2] == PicturePack::kEmpty
                                                                     : map[map.size() - 2] != PicturePack::kEmpty &&
                                                                           map[map.size() - 2] + map.back() == tile);
    if (goesOn)
        ++map.back();
    else
        map.insert(map.end(), {tile, 1});
}

} // namespace

image::Image sheetOf(const image::Image& picture, std::span<const int> places, int columns, int border) {
    const int across = tilesAcross(picture.width), count = static_cast<int>(places.size()), cell = kTileSide + 2 * border;
    image::Image sheet(columns * cell, (count + columns - 1) / columns * cell);
    for (int i = 0; i < count; ++i) {
        const int place = places[static_cast<std::size_t>(i)];
        const ivec2 from = ivec2(place % across, place / across) * kTileSide - border, to = ivec2(i % columns, i / columns) * cell;
        for (int y = 0; y < cell; ++y)
            for (int x = 0; x < cell; ++x) { // beyond its rim the picture goes on as it ends
                const image::Color8 color =
                    picture.at(std::clamp(from.x + x, 0, picture.width - 1), std::clamp(from.y + y, 0, picture.height - 1));
                sheet.set(to.x + x, to.y + y, color.a == 0 ? image::Color8{0, 0, 0, 0} : color);
            }
    }
    return sheet;
}

int PicturePack::add(const image::Image& picture, image::WebpKind kind) {
    const int across = tilesAcross(picture.width), places = across * tilesAcross(picture.height);
    std::vector<int> fresh; // places of tiles that are new
    Map map;
    for (int place = 0; place < places; ++place) {
        const image::Image tile = tileOf(picture, place);
        if (isEmpty(tile)) {
            appendRun(map, kEmpty);
            continue;
        }
        const std::string key = (kind == image::WebpKind::exact ? "e" : "p") + picture::digestOf(tile.rgba);
        const auto [found, isNew] = tiles_.emplace(key, nextTile_);
        if (isNew) {
            ++nextTile_;
            fresh.push_back(place);
        }
        appendRun(map, found->second);
    }
    if (!fresh.empty()) {
        const int count = static_cast<int>(fresh.size()), columns = std::min(count, across);
        const int border = kind == image::WebpKind::photo ? kPhotoBorder : 0;
        const Piece piece = addPiece(image::encodeWebp(sheetOf(picture, fresh, columns, border), kind));
        sheets_.push_back({piece, nextTile_ - count, count, columns, border});
    }
    const auto [number, isNew] = numbersOfMaps_.emplace(map, static_cast<int>(maps_.size()));
    if (isNew) maps_.push_back(std::move(map));
    return number->second;
}

PicturePack::Piece PicturePack::addPiece(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t kGroup = 3; // bytes that four letters of base64 stand for
    bytes_.resize((bytes_.size() + kGroup - 1) / kGroup * kGroup);
    const Piece piece{bytes_.size(), bytes.size()};
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return piece;
}

} // namespace shadowlab::course
