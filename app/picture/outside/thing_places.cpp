// SPDX-License-Identifier: MIT
#include "app/picture/outside/thing_places.h"

#include <algorithm>
#include <ranges>

#include "app/picture/outside/shape_painter.h"

namespace shadowlab::picture {

namespace {

constexpr double kCellEm = 0.5;            ///< of the grid: about half a letter's height
constexpr std::size_t kMostPlaces = 32;    ///< tried for each label
constexpr std::size_t kMostSegments = 400; ///< looked at for places: a thing of more is sampled
constexpr double kSmallestEm = 0.6;        ///< width or height of a thing that is large enough to be told from a point
constexpr double kBorderEm = 0.5;          ///< points nearer to the picture's border are no places

/// A point that may be labelled, and how hard it is to see which thing it belongs to.
struct Place {
    dvec2 pixel{0.0};
    double crowd = 0;
};

/// Other things around a point, in its own cell and the eight around it.
double crowdAround(const CoverGrid& cover, const dvec2& pixel, std::size_t thing) {
    const ivec2 middle = cover.cellAt(pixel);
    double crowd = 0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            const ivec2 cell = glm::clamp(middle + ivec2(x, y), ivec2(0), cover.cells() - 1);
            crowd += cover.otherLines(cell, thing) + 0.5 * cover.otherFaces(cell, thing);
        }
    return crowd;
}

std::vector<dvec2> clearest(std::vector<Place> places) {
    std::ranges::stable_sort(places, {}, &Place::crowd);
    std::vector<dvec2> pixels;
    for (const Place& place : places | std::views::take(kMostPlaces))
        pixels.push_back(place.pixel);
    return pixels;
}

/// One thing while its places are looked for.
class Thing {
public:
    explicit Thing(std::size_t number) : number_(number) {}

    void enter(const SceneShape& shape, const scene::Camera& camera, ivec2 size, CoverGrid& cover) {
        const auto fromTop = [&](const vec3& screen) { return dvec2(screen.x, size.y - static_cast<double>(screen.y)); };
        if (shape.kind == SceneShape::Kind::lines) {
            for (const ScreenSegment& segment : projectSegments(shape.pointsWorld, camera, size)) {
                segments_.push_back({fromTop(segment.from), fromTop(segment.to)});
                cover.addLine(segments_.back()[0], segments_.back()[1], number_);
            }
        } else {
            for (auto corners : projectFaces(shape.pointsWorld, camera, size)) {
                for (dvec2& corner : corners)
                    corner.y = size.y - corner.y;
                hasFaces_ = true;
                cover.addTriangle(corners, number_);
            }
        }
    }

    /// Empty where the thing is not in the picture, or no larger than a point.
    [[nodiscard]] std::vector<dvec2> places(const CoverGrid& cover, ivec2 size, double em) const {
        const PixelBox within{dvec2(kBorderEm * em), dvec2(size) - kBorderEm * em};
        std::vector<Place> found = onLines(cover, within, em);
        // A face is named within it; its outline only where it is too small for that.
        if (std::vector<Place> faces = onFaces(cover, within); !faces.empty()) found = std::move(faces);
        return clearest(std::move(found));
    }

private:
    [[nodiscard]] std::vector<Place> onLines(const CoverGrid& cover, const PixelBox& within, double em) const {
        std::vector<Place> places;
        PixelBox around{dvec2(1e9), dvec2(-1e9)};
        const std::size_t stride = segments_.size() / kMostSegments + 1;
        for (std::size_t i = 0; i < segments_.size(); i += stride) {
            auto [from, to] = segments_[i];
            if (!cutToBox(from, to, within)) continue;
            around = {glm::min(around.lower, glm::min(from, to)), glm::max(around.upper, glm::max(from, to))};
            const int pieces = std::clamp(static_cast<int>(glm::length(to - from) / (2 * em)), 1, 12);
            for (int piece = 0; piece < pieces; ++piece) {
                const dvec2 pixel = glm::mix(from, to, (piece + 0.5) / pieces);
                places.push_back({pixel, crowdAround(cover, pixel, number_)});
            }
        }
        const dvec2 extent = around.upper - around.lower;
        if (std::max(extent.x, extent.y) < kSmallestEm * em) places.clear();
        return places;
    }

    /// Middles of cells well within the face.
    [[nodiscard]] std::vector<Place> onFaces(const CoverGrid& cover, const PixelBox& within) const {
        std::vector<Place> places;
        dvec2 sum(0.0);
        for (int y = 0; hasFaces_ && y < cover.cells().y; ++y)
            for (int x = 0; x < cover.cells().x; ++x) {
                const dvec2 pixel = cover.middleOf({x, y});
                if (!cover.hasFace({x, y}, number_) || !within.holds(pixel)) continue;
                double crowd = crowdAround(cover, pixel, number_);
                for (const ivec2 beside : {ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1)})
                    if (!cover.hasFace(glm::clamp(ivec2(x, y) + beside, ivec2(0), cover.cells() - 1), number_)) ++crowd;
                places.push_back({pixel, crowd});
                sum += pixel;
            }
        // Of equally clear places, those in the middle of what is seen of the thing.
        const dvec2 middle = sum / std::max(1.0, static_cast<double>(places.size()));
        for (Place& place : places)
            place.crowd += glm::length(place.pixel - middle) / glm::length(within.upper);
        return places;
    }

    std::size_t number_;
    std::vector<std::array<dvec2, 2>> segments_;
    bool hasFaces_ = false;
};

} // namespace

ThingPlaces thingPlaces(std::span<const NamedPoint> points, std::span<const SceneShape* const> shapes,
                        const scene::Camera& camera, ivec2 pictureSize, double em) {
    ThingPlaces found{CoverGrid(pictureSize, std::max(2.0, kCellEm * em)), {}};
    std::vector<const SceneShape*> first; // of each thing
    std::vector<Thing> things;
    for (const SceneShape* shape : shapes) {
        if (shape->label.empty()) continue; // nothing to be called by
        const auto known = std::ranges::find(first, shape->label, [](const SceneShape* one) -> const std::string& { return one->label; });
        const auto number = static_cast<std::size_t>(known - first.begin());
        if (known == first.end()) {
            first.push_back(shape);
            things.emplace_back(number);
        }
        things[number].enter(*shape, camera, pictureSize, found.cover);
    }
    const PixelBox picture{dvec2(0), dvec2(pictureSize)};
    for (const NamedPoint& point : points) {
        // As a segment of no length: it is cut off behind the camera as any other.
        const std::array<dvec3, 2> twice{point.placeWorld, point.placeWorld};
        for (const ScreenSegment& segment : projectSegments(twice, camera, pictureSize)) {
            const dvec2 pixel(segment.from.x, pictureSize.y - static_cast<double>(segment.from.y));
            if (picture.holds(pixel)) found.wishes.push_back({point.text, point.colorLinear, CoverGrid::kMostThings, {pixel}});
        }
    }
    for (std::size_t i = 0; i < things.size(); ++i)
        if (std::vector<dvec2> places = things[i].places(found.cover, pictureSize, em); !places.empty())
            found.wishes.push_back({first[i]->label, first[i]->colorLinear, i, std::move(places)});
    return found;
}

} // namespace shadowlab::picture
