// SPDX-License-Identifier: MIT
#include "app/figures/radiosity/patch_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtc/constants.hpp>

#include "techniques/probed/patch_exchange.h"

namespace shadowlab::figures {

namespace {

constexpr int kTriedDirections = 1500;   ///< some five degrees from one to the next
constexpr double kSteepest = 0.9;        ///< of the viewer's height: from right above, up would be no direction
constexpr double kSmallest = 0.3;        ///< size of the smaller surface as it is drawn, in that of the larger one
constexpr double kOfDistance = 0.35;     ///< radius to which a surface is magnified at most, in the distance
constexpr double kFarthest = 2.2;        ///< distance that is drawn, in the two radii together
constexpr double kShrink = 0.85;         ///< sizes that are tried until neither covers the other
constexpr double kLeastMagnified = 1e-4; ///< below, one may cover the other
constexpr double kRim = 1e-6;            ///< of their size: surfaces that touch overlap by rounding

double radius(const PatchProbe& patch) {
    double most = 0;
    for (const dvec3& corner : patch.cornersWorld)
        most = std::max(most, glm::length(corner - patch.centreWorld));
    return most;
}

/// `part` of `whole`, and no more than 1.
double share(double part, double whole) { return std::min(part / whole, 1.0); }

/// How well a surface is seen whose normal has that much of the way to the viewer: 1 from its front, -0.5 from its side, and
/// somewhat better from behind.
double shown(double towardViewer) {
    return towardViewer > 0 ? -0.5 + 1.5 * share(towardViewer, 0.5) : -0.5 + 0.8 * share(-towardViewer, 0.4);
}

/// How much of a direction's length is seen; 60 % are as good as all.
double shownLength(const dvec3& directionWorld, const dvec3& towardViewerWorld) {
    return share(glm::length(glm::cross(directionWorld, towardViewerWorld)), 0.6);
}

/// 1 where an angle looks as large as it is, 0 where it looks as wrong as can be.
double shownAngle(const PatchView& view, const dvec3& a, const dvec3& b) {
    const dvec2 u = view.of(a), v = view.of(b);
    const double lengths = glm::length(u) * glm::length(v);
    if (lengths < 1e-6) return 0;
    const double drawn = std::acos(glm::clamp(glm::dot(u, v) / lengths, -1.0, 1.0));
    const double is = std::acos(glm::clamp(glm::dot(a, b), -1.0, 1.0));
    return 1 - std::abs(drawn - is) / glm::pi<double>();
}

/// The directions of a spiral from pole to pole lie about equally dense everywhere.
dvec3 direction(int i) {
    const double y = 1 - (2.0 * i + 1) / kTriedDirections, away = std::sqrt(1 - y * y);
    const double angle = glm::pi<double>() * (3 - std::sqrt(5.0)) * i; // the golden angle
    return {away * std::sin(angle), y, away * std::cos(angle)};
}

class Search {
public:
    Search(const PatchProbe& j, const PatchProbe& k) : j_(j), k_(k), wayWorld_(k.centreWorld - j.centreWorld) {
        const double distance = glm::length(wayWorld_), radiusJ = radius(j), radiusK = radius(k);
        const double least = std::min(kSmallest * std::max(radiusJ, radiusK), kOfDistance * distance);
        first_.magnified = {std::max(1.0, least / radiusJ), std::max(1.0, least / radiusK)};
        const double reach = first_.magnified[0] * radiusJ + first_.magnified[1] * radiusK;
        first_.distanceShare = share(kFarthest * reach, distance);
    }

    [[nodiscard]] PatchView best() const {
        PatchView best;
        double most = -std::numeric_limits<double>::infinity();
        for (int i = 0; i < kTriedDirections; ++i) {
            const dvec3 towardViewer = direction(i);
            if (std::abs(towardViewer.y) > kSteepest) continue;
            PatchView view = from(towardViewer);
            const double worth = valueOf(view);
            if (worth <= most) continue;
            most = worth;
            best = view;
        }
        return best;
    }

private:
    [[nodiscard]] PatchView from(const dvec3& towardViewerWorld) const {
        PatchView view = first_;
        view.towardViewerWorld = towardViewerWorld;
        view.rightWorld = glm::normalize(glm::cross(dvec3(0, 1, 0), towardViewerWorld));
        view.upWorld = glm::cross(towardViewerWorld, view.rightWorld);
        double shrunk = 1;
        while (shrunk > kLeastMagnified && overlaps(view)) {
            shrunk *= kShrink;
            view.magnified = {shrunk * first_.magnified[0], shrunk * first_.magnified[1]};
        }
        return view;
    }

    [[nodiscard]] bool overlaps(const PatchView& view) const {
        return overlap(drawnCorners(j_, view, view.magnified[0], dvec2(0)),
                       drawnCorners(k_, view, view.magnified[1], view.of(view.distanceShare * wayWorld_)));
    }

    /// The weights are a matter of taste, tried on rooms: fronts before angles, angles before the habit of looking from above.
    [[nodiscard]] double valueOf(const PatchView& view) const {
        const dvec3 &d = view.towardViewerWorld, r = glm::normalize(wayWorld_);
        const double frontJ = shown(glm::dot(j_.normalWorld, d)), frontK = shown(glm::dot(k_.normalWorld, d));
        const double lengths =
            std::min({shownLength(j_.normalWorld, d), shownLength(k_.normalWorld, d), shownLength(r, d)});
        const double angles = shownAngle(view, j_.normalWorld, r) + shownAngle(view, k_.normalWorld, -r);
        const double isFromAbove = d.y > 0.1 && d.y < 0.7 ? 1 : 0;
        const double shrunk = 1 - view.magnified[0] / first_.magnified[0];
        return std::min(frontJ, frontK) + 0.3 * (frontJ + frontK) + 0.8 * lengths + 0.5 * angles + 0.2 * isFromAbove -
               1.2 * shrunk;
    }

    const PatchProbe &j_, &k_;
    dvec3 wayWorld_;
    PatchView first_; ///< its sizes
};

} // namespace

PatchView patchView(const PatchProbe& j, const PatchProbe& k) { return Search(j, k).best(); }

std::vector<dvec2> drawnCorners(const PatchProbe& patch, const PatchView& view, double magnified, dvec2 centre) {
    std::vector<dvec2> corners;
    for (const dvec3& corner : patch.cornersWorld)
        corners.push_back(centre + magnified * view.of(corner - patch.centreWorld));
    return corners;
}

bool overlap(const std::vector<dvec2>& a, const std::vector<dvec2>& b) {
    // Convex polygons lie apart where some edge of one has all of the other behind it.
    for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)})
        for (std::size_t i = 0; i < one->size(); ++i) {
            const dvec2 from = (*one)[i], along = (*one)[(i + 1) % one->size()] - from, across(-along.y, along.x);
            if (along == dvec2(0)) continue; // an edge that is seen from its end
            double inLow = 0, inHigh = 0, low = std::numeric_limits<double>::infinity(), high = -low;
            for (const dvec2& corner : *one) {
                inLow = std::min(inLow, glm::dot(corner - from, across));
                inHigh = std::max(inHigh, glm::dot(corner - from, across));
            }
            for (const dvec2& corner : *other) {
                low = std::min(low, glm::dot(corner - from, across));
                high = std::max(high, glm::dot(corner - from, across));
            }
            const double rim = kRim * glm::dot(along, along);
            if (low >= inHigh - rim || high <= inLow + rim) return false;
        }
    return true;
}

} // namespace shadowlab::figures
