// SPDX-License-Identifier: MIT
#include "app/picture/outside/label_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/gtc/constants.hpp>

namespace shadowlab::picture {

namespace {

constexpr double kMostOfPicture = 0.12; ///< that labels may cover together: more would hide what they explain
constexpr double kGap = 0.35;           ///< em, between labels, and to the picture's border
constexpr int kDirections = 16;
constexpr std::array kDistances = {0.8, 1.6, 2.6, 4.0, 6.0, 9.0}; ///< em, from the thing to the label's border

// What a place costs, in em of distance that one would rather go. Lines under a label are lost to the viewer; faces shine on
// around it.
constexpr double kLinesCost = 12, kFacesCost = 2.5, kLaterPlaceCost = 0.12, kCrossedCellCost = 0.25;

/// Do two segments cross?
bool cross(const dvec2& a, const dvec2& b, const dvec2& c, const dvec2& d) {
    const auto side = [](const dvec2& p, const dvec2& q, const dvec2& r) {
        return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

bool meets(dvec2 from, dvec2 to, const PixelBox& box) { return cutToBox(from, to, box); }

class LabelLayout {
public:
    LabelLayout(const CoverGrid& cover, const LabelRoom& room) : cover_(cover), room_(room) {}

    /// The label at its best place; nothing when there is none.
    [[nodiscard]] std::optional<PlacedLabel> best(const LabelWish& wish, const dvec2& size) const {
        std::optional<PlacedLabel> best;
        double least = std::numeric_limits<double>::infinity();
        const auto consider = [&](const dvec2& place, const dvec2& middle, double cost) {
            if (cost >= least) return;
            const PixelBox box{glm::round(middle - 0.5 * size), glm::round(middle - 0.5 * size) + size};
            const PlacedLabel label{wish.text, wish.colorLinear, box, place};
            if (!isFree(label)) return;
            cost += kLinesCost * cover_.lineShare(box) + kFacesCost * cover_.otherFaceShare(box, wish.thing);
            if (!label.standsOnIt()) cost += kCrossedCellCost * crossedLines(label, wish.thing);
            if (cost >= least) return;
            least = cost;
            best = label;
        };
        double placeCost = 0;
        for (const dvec2& place : wish.places) {
            const PixelBox around{place - 0.5 * size, place + 0.5 * size};
            if (cover_.isOnFace(around, wish.thing)) consider(place, place, placeCost);
            for (const double distance : kDistances)
                for (int i = 0; i < kDirections; ++i) {
                    const double angle = i * glm::two_pi<double>() / kDirections;
                    const dvec2 direction(std::cos(angle), std::sin(angle));
                    // From the middle of a box to its border is at most half its width and half its height along their axes.
                    const dvec2 half = 0.5 * size * glm::abs(direction);
                    consider(place, place + (distance * room_.em + half.x + half.y) * direction, placeCost + distance);
                }
            placeCost += kLaterPlaceCost;
        }
        return best;
    }

    void add(const PlacedLabel& label) { placed_.push_back(label); }
    [[nodiscard]] const std::vector<PlacedLabel>& placed() const { return placed_; }

private:
    [[nodiscard]] bool isFree(const PlacedLabel& label) const {
        const double gap = kGap * room_.em;
        const dvec2 size(room_.pictureSize);
        if (label.box.lower.x < gap || label.box.lower.y < room_.topPixels + gap || label.box.upper.x > size.x - gap ||
            label.box.upper.y > size.y - gap)
            return false;
        return std::ranges::none_of(placed_, [&](const PlacedLabel& other) {
            if (label.box.overlaps(other.box, gap)) return true;
            const PixelBox ring{other.place - gap, other.place + gap};
            const bool covers = label.box.overlaps(ring) || meets(other.lineStart(), other.place, label.box);
            const bool isCut = meets(label.lineStart(), label.place, other.box) ||
                               cross(label.lineStart(), label.place, other.lineStart(), other.place);
            return covers || isCut;
        });
    }

    /// Cells with lines of other things that the line to the thing crosses.
    [[nodiscard]] int crossedLines(const PlacedLabel& label, std::size_t thing) const {
        const dvec2 from = label.lineStart();
        constexpr int kSteps = 12;
        int crossed = 0;
        for (int i = 0; i < kSteps; ++i)
            crossed += cover_.otherLines(cover_.cellAt(glm::mix(from, label.place, (i + 0.5) / kSteps)), thing) > 0;
        return crossed;
    }

    const CoverGrid& cover_;
    const LabelRoom& room_;
    std::vector<PlacedLabel> placed_;
};

} // namespace

std::vector<PlacedLabel> placeLabels(const std::vector<LabelWish>& wishes, const CoverGrid& cover, const LabelRoom& room,
                                     const std::function<dvec2(const std::string&)>& sizeOf) {
    LabelLayout layout(cover, room);
    const double most = kMostOfPicture * room.pictureSize.x * room.pictureSize.y;
    double covered = 0;
    for (const LabelWish& wish : wishes) {
        const dvec2 size = sizeOf(wish.text);
        if (covered + size.x * size.y > most) break; // not a shorter, less important one instead
        if (const auto label = layout.best(wish, size)) {
            covered += size.x * size.y;
            layout.add(*label);
        }
    }
    return layout.placed();
}

} // namespace shadowlab::picture
