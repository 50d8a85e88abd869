// SPDX-License-Identifier: MIT
#include "app/figures/space_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtc/constants.hpp>

namespace shadowlab::figures {

namespace {

constexpr double kAway = 5;       ///< of the radius of what is shown: a moderate perspective, as of things on a desk
constexpr int kDirections = 1000; ///< some six degrees apart
constexpr double kSteepestView = 0.8; ///< sine of the angle above or below the horizon

} // namespace

SpaceView::SpaceView(std::span<const dvec3> shownWorld, const dvec3& towardViewerWorld, const drawing::Box& area, dvec2 margin,
                     double mostScale)
    : towardViewerWorld_(towardViewerWorld) {
    dvec3 low(1e300), high(-1e300);
    for (const dvec3& place : shownWorld) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    const dvec3 middle = 0.5 * (low + high);
    away_ = kAway * std::max(0.5 * glm::length(high - low), 1e-9);
    viewerWorld_ = middle + away_ * towardViewerWorld_;
    rightWorld_ = glm::normalize(glm::cross(dvec3(0, 1, 0), towardViewerWorld_));
    upWorld_ = glm::cross(towardViewerWorld_, rightWorld_);
    dvec2 least(1e300), most(-1e300);
    for (const dvec3& place : shownWorld) {
        least = glm::min(least, flat(place));
        most = glm::max(most, flat(place));
    }
    const dvec2 room = area.size - 2.0 * margin, extent = glm::max(most - least, dvec2(1e-9));
    scale_ = std::min({room.x / extent.x, room.y / extent.y, mostScale * away_});
    centre_ = area.corner + 0.5 * area.size - scale_ * 0.5 * (least + most);
    if (std::isfinite(mostScale)) centre_.y += 0.5 * (room.y - scale_ * extent.y);
}

dvec2 SpaceView::flat(const dvec3& positionWorld) const {
    const dvec3 way = positionWorld - viewerWorld_;
    return dvec2(glm::dot(way, rightWorld_), -glm::dot(way, upWorld_)) / depth(positionWorld);
}

bool SpaceView::showsFront(const std::array<dvec3, 3>& c) const {
    return glm::dot(glm::cross(c[1] - c[0], c[2] - c[0]), viewerWorld_ - c[0]) > 0;
}

dvec3 bestDirection(const std::function<double(const dvec3&)>& worth) {
    // A spiral from pole to pole with the golden angle from one to the next: about equally dense everywhere.
    dvec3 best(0, 0, 1);
    double most = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < kDirections; ++i) {
        const double y = 1 - (2.0 * i + 1) / kDirections, across = std::sqrt(1 - y * y);
        if (std::abs(y) > kSteepestView) continue;
        const double angle = glm::pi<double>() * (3 - std::sqrt(5.0)) * i;
        const dvec3 direction(across * std::sin(angle), y, across * std::cos(angle));
        const double value = worth(direction);
        if (value <= most) continue;
        most = value;
        best = direction;
    }
    return best;
}

} // namespace shadowlab::figures
