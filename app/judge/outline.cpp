// SPDX-License-Identifier: MIT
#include "app/judge/outline.h"

#include <algorithm>
#include <optional>

#include "app/judge/grid.h"
#include "app/judge/slot_errors.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::judge {

namespace {

using trace::SurfacePoint;
using trace::Visibility;

constexpr int kSteps = 6; ///< halvings of the way between two centres: 1/64 px is left, its middle is taken
constexpr std::size_t kPieceSize = 64; ///< edges that one thread divides at a time

/// What an eye ray sees.
struct Seen {
    SurfacePoint point;
    Visibility visibility = Visibility::noSurface;
};

class Dividing {
public:
    Dividing(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size, int light)
        : tracer_(tracer), rays_(tracer.eyeRays(camera, size)), light_(light),
          pixelPerMetreAway_(2.0 * std::tan(glm::radians(camera.fovYDegrees) / 2) / size.y) {}

    [[nodiscard]] Seen look(dvec2 pixel) const {
        const SurfacePoint point = tracer_.eyePoint(rays_, pixel);
        return {point, point ? tracer_.visibility(point, light_) : Visibility::noSurface};
    }

    /// Where the shadow ends on the way from one centre to the other; nothing where it does not end on a surface.
    [[nodiscard]] std::optional<dvec2> crossing(const BoundaryEdge& edge) const {
        const dvec2 middle = dvec2(edge) / 2.0, half = edge.x % 2 == 0 ? dvec2(0.5, 0) : dvec2(0, 0.5);
        dvec2 lit = middle - half, dark = middle + half;
        Seen atLit = look(lit), atDark = look(dark);
        if (atLit.visibility != Visibility::lit) std::swap(lit, dark), std::swap(atLit, atDark);
        for (int step = 0; step < kSteps; ++step) {
            const dvec2 between = 0.5 * (lit + dark);
            const Seen seen = look(between);
            const bool isLit = seen.visibility == Visibility::lit;
            (isLit ? lit : dark) = between;
            (isLit ? atLit : atDark) = seen;
        }
        if (atDark.visibility != Visibility::shadowed || isGap(atLit.point, atDark.point)) return std::nullopt;
        return 0.5 * (lit + dark);
    }

private:
    /// Do two points a sixty-fourth of a pixel apart lie on different surfaces, one behind the other? On one surface they
    /// are a pixel's width apart only where it is seen at less than a degree, and then mostly on one triangle.
    [[nodiscard]] bool isGap(const SurfacePoint& a, const SurfacePoint& b) const {
        if (a.primitive == b.primitive) return false;
        if (tracer_.world().objects[a.primitive] != tracer_.world().objects[b.primitive]) return true;
        const double apart = glm::distance(tracer_.positionCentred(a), tracer_.positionCentred(b));
        return apart > pixelPerMetreAway_ * tracer_.distance(rays_, a);
    }

    const trace::SceneTracer& tracer_;
    trace::EyeRays rays_;
    int light_;
    double pixelPerMetreAway_; ///< width of a pixel in metres, one metre from the eye
};

using Crossings = std::vector<std::optional<dvec2>>;

Crossings crossings(const Dividing& dividing, const std::vector<BoundaryEdge>& edges) {
    Crossings found(edges.size());
    trace::parallelFor((edges.size() + kPieceSize - 1) / kPieceSize, [&](std::size_t piece) {
        const std::size_t end = std::min(edges.size(), (piece + 1) * kPieceSize);
        for (std::size_t i = piece * kPieceSize; i < end; ++i)
            found[i] = dividing.crossing(edges[i]);
    });
    return found;
}

/// The crossings around each square between four centres, joined.
class Joining {
public:
    Joining(const Dividing& dividing, const Truth& centres, const std::vector<BoundaryEdge>& edges,
            const Crossings& found)
        : dividing_(dividing), centres_(centres), found_(found),
          numbers_(2 * centres.size.x + 1, 2 * centres.size.y + 1, -1) {
        for (std::size_t i = 0; i < edges.size(); ++i)
            if (found[i]) numbers_.at(edges[i].x, edges[i].y) = static_cast<int>(i);
    }

    std::vector<OutlineSegment> segments() const {
        std::vector<OutlineSegment> segments;
        for (int y = 1; y < centres_.size.y; ++y)
            for (int x = 1; x < centres_.size.x; ++x)
                joinAround({x, y}, segments);
        return segments;
    }

private:
    [[nodiscard]] const dvec2* crossingAt(ivec2 halves) const {
        const int number = numbers_.at(halves.x, halves.y);
        return number < 0 ? nullptr : &*found_[static_cast<std::size_t>(number)];
    }

    /// `corner` is where four pixels meet; their centres are half a pixel from it.
    void joinAround(ivec2 corner, std::vector<OutlineSegment>& segments) const {
        const ivec2 middle = 2 * corner;
        const dvec2* const above = crossingAt(middle - ivec2(0, 1));
        const dvec2* const below = crossingAt(middle + ivec2(0, 1));
        const dvec2* const left = crossingAt(middle - ivec2(1, 0));
        const dvec2* const right = crossingAt(middle + ivec2(1, 0));
        std::vector<const dvec2*> there;
        for (const dvec2* crossing : {above, below, left, right})
            if (crossing) there.push_back(crossing);
        if (there.size() == 2) {
            segments.push_back({*there[0], *there[1]});
        } else if (there.size() == 4) {
            // Two lines, and two ways to join them: the middle belongs to the corners that are of its kind.
            const bool litHere = dividing_.look(corner).visibility == Visibility::lit;
            const bool litUpperLeft =
                centres_.visibility[centres_.index(corner.x - 1, corner.y - 1)] == Visibility::lit;
            segments.push_back({*above, litHere == litUpperLeft ? *right : *left});
            segments.push_back({*below, litHere == litUpperLeft ? *left : *right});
        }
    }

    const Dividing& dividing_;
    const Truth& centres_;
    const Crossings& found_;
    Grid<int> numbers_; ///< of the crossing on each edge, in half pixels as BoundaryEdge; -1: none
};

} // namespace

std::vector<OutlineSegment> shadowOutline(const trace::SceneTracer& tracer, const scene::Camera& camera,
                                          const Truth& centres, int light) {
    const Dividing dividing(tracer, camera, centres.size, light);
    const std::vector<BoundaryEdge> edges = trueBoundary(centres);
    const Crossings found = crossings(dividing, edges);
    return Joining(dividing, centres, edges, found).segments();
}

double lengthPx(const std::vector<OutlineSegment>& outline) {
    double sum = 0;
    for (const OutlineSegment& segment : outline)
        sum += glm::distance(segment.from, segment.to);
    return sum;
}

} // namespace shadowlab::judge
