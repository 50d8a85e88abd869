// The light lies in the plane, so along one of its rays the count changes only where the ray meets the cut of a cap. Between two
// neighbouring rays through ends of these cuts, and through places where two of them cross, they keep their order: what lies
// between two of them there is a quadrilateral.
// SPDX-License-Identifier: MIT
#include "app/figures/volume/volume_areas.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/gtc/constants.hpp>

#include "techniques/probed/volume_probe.h"

namespace shadowlab::figures {

namespace {

using CapLine = VolumeProbe::CapLine;

constexpr std::size_t kMostPairs = 1500; ///< of finer meshes cuts are too short for a crossing to be seen
constexpr int kSpokes = 16;              ///< rays that are there in any case: no area is wider than they are apart

double cross(dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; }

struct Ray {
    dvec2 origin{0.0}, way{0.0};
};

/// Rays by one number: the angle around the light, or metres across parallel rays.
struct Rays {
    const PlaneLight& light;
    double start = 0; ///< metres from the middle of the plane to where parallel rays begin

    [[nodiscard]] Ray at(double number) const {
        if (!light.isDirection) return {light.at, {std::cos(number), std::sin(number)}};
        return {number * dvec2(-light.at.y, light.at.x) + start * light.at, -light.at};
    }
    [[nodiscard]] double numberOf(dvec2 place) const {
        if (light.isDirection) return glm::dot(place, dvec2(-light.at.y, light.at.x));
        return std::atan2(place.y - light.at.y, place.x - light.at.x);
    }
};

/// How far along the ray it meets the cut's line; none where it is parallel to it.
std::optional<double> distanceTo(const Ray& ray, const CapLine& cap) {
    const dvec2 along = cap.to - cap.from;
    const double area = cross(ray.way, along);
    if (area == 0) return std::nullopt;
    return cross(cap.from - ray.origin, along) / area;
}

bool isOn(const Ray& ray, const CapLine& cap) {
    return (cross(ray.way, cap.from - ray.origin) < 0) != (cross(ray.way, cap.to - ray.origin) < 0);
}

void addCrossings(std::vector<double>& numbers, std::span<const CapLine> caps, const Rays& rays) {
    if (caps.size() > kMostPairs) return;
    for (std::size_t i = 0; i < caps.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const dvec2 a = caps[i].to - caps[i].from, b = caps[j].to - caps[j].from,
                        between = caps[j].from - caps[i].from;
            const double area = cross(a, b);
            if (area == 0) continue;
            const double s = cross(between, b) / area, t = cross(between, a) / area;
            if (s > 0 && s < 1 && t > 0 && t < 1) numbers.push_back(rays.numberOf(caps[i].from + s * a));
        }
}

} // namespace

dvec2 PlaneLight::toward(dvec2 place) const {
    if (isDirection) return at;
    const dvec2 way = at - place;
    return glm::length(way) > 0 ? glm::normalize(way) : dvec2(0, 1);
}

int countAt(dvec2 place, std::span<const CapLine> caps, const PlaneLight& light) {
    const Ray ray{place, light.toward(place)};
    const double length = light.isDirection ? std::numeric_limits<double>::infinity() : glm::length(light.at - place);
    int count = 0;
    for (const CapLine& cap : caps)
        if (isOn(ray, cap))
            if (const auto distance = distanceTo(ray, cap); distance && *distance > 0 && *distance < length)
                count += cap.sign;
    return count;
}

std::vector<CountedArea> countedAreas(std::span<const CapLine> caps, const PlaneLight& light, const drawing::Box& within) {
    double farthest = glm::length(within.size);
    for (const dvec2 corner : {within.corner, within.corner + within.size, within.corner + dvec2(within.size.x, 0),
                               within.corner + dvec2(0, within.size.y)})
        farthest = std::max(farthest, glm::length(corner - (light.isDirection ? dvec2(0.0) : light.at)));
    for (const CapLine& cap : caps)
        farthest = std::max({farthest, glm::length(cap.from), glm::length(cap.to)});
    const Rays rays{light, 2 * farthest};
    const double reach = 4 * farthest; // of every ray: beyond the rectangle, wherever it begins

    std::vector<double> numbers;
    for (const CapLine& cap : caps)
        numbers.insert(numbers.end(), {rays.numberOf(cap.from), rays.numberOf(cap.to)});
    addCrossings(numbers, caps, rays);
    if (!light.isDirection)
        for (int i = 0; i < kSpokes; ++i)
            numbers.push_back(glm::two_pi<double>() * i / kSpokes - glm::pi<double>());
    std::ranges::sort(numbers);
    if (!light.isDirection) numbers.push_back(numbers.front() + glm::two_pi<double>());

    std::vector<CountedArea> areas;
    for (std::size_t i = 0; i + 1 < numbers.size(); ++i) {
        const double width = numbers[i + 1] - numbers[i];
        if (width < 1e-12 * (light.isDirection ? farthest : 1)) continue;
        const Ray middle = rays.at(numbers[i] + 0.5 * width), first = rays.at(numbers[i]),
                  last = rays.at(numbers[i + 1]);
        struct Event {
            double distance = 0;
            const CapLine* cap = nullptr;
        };
        std::vector<Event> events;
        for (const CapLine& cap : caps)
            if (isOn(middle, cap))
                if (const auto distance = distanceTo(middle, cap); distance && *distance > 0)
                    events.push_back({*distance, &cap});
        std::ranges::sort(events, {}, &Event::distance);
        const auto place = [&](const Ray& ray, const CapLine* cap) {
            const auto distance = cap ? distanceTo(ray, *cap) : std::optional(reach);
            return ray.origin + distance.value_or(reach) * ray.way;
        };
        int count = 0;
        for (std::size_t k = 0; k < events.size(); ++k) {
            count += events[k].cap->sign;
            if (count == 0) continue;
            const CapLine* next = k + 1 < events.size() ? events[k + 1].cap : nullptr;
            areas.push_back(
                {count,
                 {place(first, events[k].cap), place(last, events[k].cap), place(last, next), place(first, next)}});
        }
    }
    return areas;
}

} // namespace shadowlab::figures
