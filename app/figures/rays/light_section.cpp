// SPDX-License-Identifier: MIT
#include "app/figures/rays/light_section.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::figures {

namespace {

constexpr double kNearly = 1e-3;
constexpr int kHalvings = 6; ///< of a step, between two places of different kind

/// A stretch of a scan line.
struct Run {
    LitArea::Kind kind;
    double from, to;
};

struct Growing {
    LitArea::Kind kind;
    std::vector<dvec2> left, right;
    Run last;
};

std::vector<Run> runsAt(const SectionOfLight& light, double y, double from, double to, double step) {
    std::vector<Run> runs;
    double begin = from;
    LitArea::Kind kind = kindAt(light, {from, y});
    const auto end = [&](double x) {
        if (kind != LitArea::Kind::all && x > begin) runs.push_back({kind, begin, x});
        begin = x;
    };
    const int steps = static_cast<int>(std::ceil((to - from) / step));
    for (int i = 1; i <= steps; ++i) {
        const double x = std::min(to, from + i * step);
        const LitArea::Kind next = kindAt(light, {x, y});
        if (next == kind) continue;
        double low = x - step, high = x;
        for (int half = 0; half < kHalvings; ++half) {
            const double middle = 0.5 * (low + high);
            (kindAt(light, {middle, y}) == kind ? low : high) = middle;
        }
        end(0.5 * (low + high));
        kind = next;
    }
    end(to);
    return runs;
}

LitArea finished(Growing&& area) {
    LitArea done{area.kind, std::move(area.left)};
    done.outline.insert(done.outline.end(), area.right.rbegin(), area.right.rend());
    return done;
}

bool follows(const Run& run, const Run& before) {
    return run.kind == before.kind && run.from < before.to && before.from < run.to;
}

} // namespace

SectionOfLight::SectionOfLight(const scene::Light& light, const DrawingPlane& plane, std::vector<dvec2> occluders)
    : isSphere_(light.type == scene::LightType::sphere), centre_(plane.of(light.positionWorld)),
      occluders_(std::move(occluders)) {
    if (isSphere_) {
        radius_ = light.radius;
        return;
    }
    // The line in which the rect's plane cuts this one, as far as it lies within both pairs of edges.
    const dvec3 normal = scene::rectNormalWorld(light);
    front_ = glm::normalize(plane.ofDirection(normal));
    const dvec2 along(-front_.y, front_.x);
    const dvec3 alongWorld = along.x * plane.rightWorld + along.y * plane.upWorld;
    double reach = 1e300;
    const dvec3 edges[] = {light.edgeUWorld, light.edgeVWorld};
    for (int i = 0; i < 2; ++i) {
        // How fast the line leaves the strip between the two sides that are parallel to the other edge.
        const dvec3 across = glm::cross(edges[1 - i], normal);
        const double speed = std::abs(glm::dot(alongWorld, across)), half = 0.5 * std::abs(glm::dot(edges[i], across));
        if (speed > 1e-12) reach = std::min(reach, half / speed);
    }
    ends_ = {centre_ - reach * along, centre_ + reach * along};
}

std::array<dvec2, 2> SectionOfLight::seenFrom(dvec2 place) const {
    if (!isSphere_) return ends_;
    const dvec2 way = glm::normalize(centre_ - place), across(-way.y, way.x);
    return {centre_ - radius_ * across, centre_ + radius_ * across};
}

bool SectionOfLight::shinesTo(dvec2 place) const {
    return isSphere_ ? glm::length(place - centre_) > radius_ : glm::dot(place - centre_, front_) > 0;
}

double SectionOfLight::share(dvec2 place) const {
    if (!shinesTo(place)) return 0;
    const auto [a, b] = seenFrom(place);
    const dvec2 along = b - a, across = glm::normalize(dvec2(-along.y, along.x));
    // Heights above the light's line, on the place's side.
    const double side = glm::dot(place - a, across) > 0 ? 1 : -1, height = side * glm::dot(place - a, across);
    if (height <= 0) return 1;
    const auto heightOf = [&](dvec2 at) { return side * glm::dot(at - a, across); };
    std::vector<dvec2> hidden; // intervals of the light, 0..1
    for (std::size_t i = 0; i + 1 < occluders_.size(); i += 2) {
        dvec2 c = occluders_[i], d = occluders_[i + 1];
        double hc = heightOf(c), hd = heightOf(d);
        // Only what lies between the light and the place; at the place's own height it is seen at infinity.
        const double low = 1e-9 * height, high = (1 - 1e-9) * height;
        if (std::max(hc, hd) <= low || std::min(hc, hd) >= high) continue;
        const auto clip = [&](dvec2& from, double& hFrom, dvec2 to, double hTo) {
            const double bound = std::clamp(hFrom, low, high);
            if (bound == hFrom) return;
            from += (to - from) * ((bound - hFrom) / (hTo - hFrom));
            hFrom = bound;
        };
        clip(c, hc, d, hd);
        clip(d, hd, c, hc);
        const auto on = [&](dvec2 at, double h) {
            const dvec2 met = place + (at - place) * (height / (height - h));
            return glm::dot(met - a, along) / glm::dot(along, along);
        };
        const double s = on(c, hc), t = on(d, hd);
        const dvec2 interval(std::clamp(std::min(s, t), 0.0, 1.0), std::clamp(std::max(s, t), 0.0, 1.0));
        if (interval.y > interval.x) hidden.push_back(interval);
    }
    std::ranges::sort(hidden, [](dvec2 p, dvec2 q) { return p.x < q.x; });
    double covered = 0, reached = 0;
    for (const dvec2& interval : hidden) {
        covered += std::max(0.0, interval.y - std::max(reached, interval.x));
        reached = std::max(reached, interval.y);
    }
    return 1 - covered;
}

LitArea::Kind kindAt(const SectionOfLight& light, dvec2 place) {
    if (!light.shinesTo(place)) return LitArea::Kind::all; // behind it there is nothing to say
    const double share = light.share(place);
    return share >= 1 - kNearly ? LitArea::Kind::all : share <= kNearly ? LitArea::Kind::none : LitArea::Kind::part;
}

std::vector<LitArea> shadowAreas(const SectionOfLight& light, const drawing::Box& within, double step) {
    std::vector<LitArea> areas;
    std::vector<Growing> open;
    const int rows = static_cast<int>(std::ceil(within.size.y / step));
    for (int row = 0; row <= rows; ++row) {
        const double y = within.corner.y + std::min(row * step, within.size.y);
        const std::vector<Run> runs = runsAt(light, y, within.corner.x, within.corner.x + within.size.x, 1.5 * step);
        std::vector<Growing> next;
        for (const Run& run : runs) {
            const auto before =
                std::ranges::find_if(open, [&](const Growing& area) { return follows(run, area.last); });
            const bool isAlone =
                std::ranges::count_if(
                    runs, [&](const Run& other) { return before != open.end() && follows(other, before->last); }) ==
                    1 &&
                std::ranges::count_if(open, [&](const Growing& area) { return follows(run, area.last); }) == 1;
            Growing area = isAlone ? std::move(*before) : Growing{run.kind, {}, {}, run};
            if (isAlone) before->left.clear(); // what is not taken over ends here
            // Where one area ends and another of its kind goes on, there is no gap between them.
            if (!isAlone && before != open.end()) {
                area.left.emplace_back(run.from, y - step);
                area.right.emplace_back(run.to, y - step);
            }
            area.left.emplace_back(run.from, y);
            area.right.emplace_back(run.to, y);
            area.last = run;
            next.push_back(std::move(area));
        }
        for (Growing& area : open) {
            const bool goesOn = std::ranges::any_of(runs, [&](const Run& run) { return follows(run, area.last); });
            if (goesOn && !area.left.empty()) {
                area.left.emplace_back(area.last.from, y);
                area.right.emplace_back(area.last.to, y);
            }
            if (area.left.size() > 1) areas.push_back(finished(std::move(area)));
        }
        open = std::move(next);
    }
    for (Growing& area : open)
        if (area.left.size() > 1) areas.push_back(finished(std::move(area)));
    return areas;
}

} // namespace shadowlab::figures
