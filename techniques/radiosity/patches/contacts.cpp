// SPDX-License-Identifier: MIT
#include "techniques/radiosity/patches/contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace shadowlab::radiosity {

namespace {

struct Segment {
    dvec3 from, to;
};

/// The edges of a face that lies close above the plane and faces it, as seen straight from above; nothing of any other.
std::vector<Segment> outlineOnto(const Plane& plane, const Face& above, double touching) {
    if (!(glm::dot(plane.normal, above.plane.normal) < 0)) return {};
    const double close = kCloseAbove * sizeOf(above.polygon);
    std::vector<Segment> segments;
    const auto onto = [&](const dvec3& corner) { return corner - plane.height(corner) * plane.normal; };
    for (std::size_t i = 0; i < above.polygon.count(); ++i) {
        const double height = plane.height(above.polygon[i]);
        if (height <= touching || height > close) return {};
        segments.push_back({onto(above.polygon[i]), onto(above.polygon[(i + 1) % above.polygon.count()])});
    }
    return segments;
}

/// Where a polygon meets a plane: all its edges, if it lies in the plane; else the segment in which it crosses or touches the
/// plane.
std::vector<Segment> meeting(const Plane& plane, const Polygon& other, double touching) {
    std::vector<Segment> segments;
    std::vector<dvec3> points;
    std::size_t within = 0;
    for (std::size_t i = 0; i < other.count(); ++i) {
        const dvec3 &a = other[i], &b = other[(i + 1) % other.count()];
        const double heightA = plane.height(a), heightB = plane.height(b);
        const bool isIn = std::abs(heightA) <= touching;
        within += isIn;
        segments.push_back({a, b});
        if (isIn)
            points.push_back(a);
        else if (std::abs(heightB) > touching && (heightA > 0) != (heightB > 0))
            points.push_back(a + heightA / (heightA - heightB) * (b - a));
    }
    if (within == other.count()) return segments;
    if (points.size() < 2) return {};
    return {{points.front(), points.back()}}; // two, because it is convex
}

/// The part of a segment inside a convex polygon of the same plane, farther than `touching` from its edges; nothing where there
/// is none.
std::optional<Segment> inside(const Segment& segment, const Polygon& polygon, const dvec3& normal, double touching) {
    double first = 0, last = 1;
    const dvec3 way = segment.to - segment.from;
    for (std::size_t i = 0; i < polygon.count(); ++i) {
        const dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.count()];
        const dvec3 inward = glm::normalize(glm::cross(normal, b - a));
        const double from = glm::dot(inward, segment.from - a) - touching, slope = glm::dot(inward, way);
        if (std::abs(slope) < 1e-300) {
            if (from < 0) return std::nullopt;
            continue;
        }
        const double crossing = -from / slope;
        (slope > 0 ? first : last) = slope > 0 ? std::max(first, crossing) : std::min(last, crossing);
    }
    if (!(last > first)) return std::nullopt;
    return Segment{segment.from + first * way, segment.from + last * way};
}

/// The two parts of a patch beside a line in its plane; nothing if one of them has no area. Pieces keep the normal of the whole: that of a sliver would be noise.
std::optional<std::array<Patch, 2>> partsBeside(const Patch& patch, const Segment& line, double touching) {
    const dvec3 across = glm::normalize(glm::cross(line.to - line.from, patch.normal));
    const Polygon left = partBefore({line.from, across}, patch.polygon, touching);
    const Polygon right = partBefore({line.from, -across}, patch.polygon, touching);
    if (hasNoArea(left) || hasNoArea(right)) return std::nullopt;
    return std::array{pieceOf(patch, left), pieceOf(patch, right)};
}

/// Cuts every piece that the segment crosses, along the segment's whole line. What a ball cuts out of a wall may have as many corners as a polygon can: that is halved first.
void cut(std::vector<Patch>& pieces, const Segment& segment, double touching) {
    for (std::size_t i = 0, count = pieces.size(); i < count; ++i) {
        const Patch patch = pieces[i];
        const std::size_t corners = patch.polygon.count();
        if (!inside(segment, patch.polygon, patch.normal, touching)) continue;
        const bool isFull = corners + 1 > Polygon::kMostCorners;
        const auto parts = partsBeside(patch, isFull ? Segment{patch.polygon[0], patch.polygon[corners / 2]} : segment, touching);
        if (!parts) continue;
        pieces[i] = parts->front();
        pieces.push_back(parts->back());
        if (!isFull) continue;
        std::swap(pieces[count], pieces.back()); // both halves are looked at
        ++count, --i;
    }
}

/// For each face the others whose boxes touch its own, in order; boxes are grown by what "close above" means. They are swept along
/// the x axis.
std::vector<std::vector<std::uint32_t>> facesNear(const Faces& faces) {
    std::vector<trace::CentredBox> boxes;
    std::vector<std::uint32_t> order;
    for (const Face& face : faces.all) {
        order.push_back(static_cast<std::uint32_t>(boxes.size()));
        boxes.emplace_back(boxOf(face.polygon)).grow(kCloseAbove * sizeOf(face.polygon));
    }
    std::ranges::stable_sort(order, {}, [&](std::uint32_t number) { return boxes[number].lower.x; });
    std::vector<std::vector<std::uint32_t>> near(faces.all.size());
    for (auto here = order.begin(); here != order.end(); ++here)
        for (auto next = here + 1; next != order.end() && boxes[*next].lower.x <= boxes[*here].upper.x; ++next)
            if (boxes[*next].touches(boxes[*here])) {
                near[*here].push_back(*next);
                near[*next].push_back(*here);
            }
    for (std::vector<std::uint32_t>& others : near)
        std::ranges::sort(others);
    return near;
}

} // namespace

std::vector<std::vector<Contact>> contactsOf(const Faces& faces) {
    const std::vector<std::vector<std::uint32_t>> near = facesNear(faces);
    std::vector<std::vector<Contact>> contacts(faces.all.size());
    for (std::uint32_t number = 0; number < faces.all.size(); ++number) {
        const Polygon& polygon = faces.all[number].polygon;
        const Plane& plane = faces.all[number].plane;
        const double touching = kTouching * sizeOf(polygon);
        for (const std::uint32_t other : near[number]) {
            const Polygon& otherPolygon = faces.all[other].polygon;
            const Plane turned{plane.point, -plane.normal};
            const bool isBeneath = isBehind(plane, otherPolygon, touching);
            if (isBeneath && !isBehind(turned, otherPolygon, touching)) continue; // a face in the plane is behind both
            std::vector<Segment> segments = meeting(plane, otherPolygon, touching);
            if (segments.empty()) segments = outlineOnto(plane, faces.all[other], touching);
            for (const Segment& segment : segments)
                // The face is enlarged by the tolerance, so the segment of faces that meet at right angles in a point has twice
                // that length.
                if (const auto part = inside(segment, polygon, plane.normal, -touching);
                    part && glm::distance(part->from, part->to) > 4 * touching)
                    contacts[number].push_back({part->from, part->to, other});
        }
    }
    return contacts;
}

std::vector<Patch> cutAtContacts(const Faces& faces, std::vector<Patch> patches) {
    const std::vector<std::vector<Contact>> contacts = contactsOf(faces);
    std::vector<Patch> all;
    for (const Patch& patch : patches) {
        std::vector<Patch> pieces{patch};
        for (const Contact& contact : contacts[patch.face])
            cut(pieces, {contact.from, contact.to}, kTouching * sizeOf(faces.all[patch.face].polygon));
        all.insert(all.end(), pieces.begin(), pieces.end());
    }
    return all;
}

} // namespace shadowlab::radiosity
