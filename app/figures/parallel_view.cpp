// SPDX-License-Identifier: MIT
#include "app/figures/parallel_view.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace shadowlab::figures {

namespace {

// Two faces that meet at more than this angle have an edge between them that is seen: balls of a few dozen segments have none.
const double kCreaseCosine = std::cos(M_PI / 6);

} // namespace

ParallelView::ParallelView(const dvec3& towardViewerWorld, const dvec3& upWorld)
    : toward_(glm::normalize(towardViewerWorld)), right_(glm::normalize(glm::cross(upWorld, toward_))),
      up_(glm::cross(toward_, right_)) {}

dvec2 ParallelView::direction(const dvec3& directionWorld) const {
    return scale_ * dvec2(glm::dot(directionWorld, right_), -glm::dot(directionWorld, up_));
}

dvec2 ParallelView::operator()(const dvec3& positionWorld) const { return offset_ + direction(positionWorld); }

void ParallelView::fit(std::span<const dvec3> placesWorld, const drawing::Box& room) {
    scale_ = 1;
    offset_ = dvec2(0.0);
    dvec2 low(1e300), high(-1e300);
    for (const dvec3& place : placesWorld) {
        low = glm::min(low, (*this)(place));
        high = glm::max(high, (*this)(place));
    }
    const dvec2 extent = glm::max(high - low, dvec2(1e-12));
    scale_ = std::min(room.size.x / extent.x, room.size.y / extent.y);
    offset_ = room.corner + 0.5 * room.size - 0.5 * scale_ * (low + high);
}

std::vector<dvec3> drawnEdgesWorld(const scene::Object& object, const dvec4& viewerWorld) {
    struct Edge {
        int faces = 0, front = 0;
        dvec3 normal{0.0};
        bool isCrease = false;
    };
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    std::vector<dvec3> positionsWorld;
    for (const vec3& position : object.mesh->positionsMesh)
        positionsWorld.push_back(transformPoint(worldFromMesh, dvec3(position)));
    // A vertex may stand there more than once, with another normal: places tell edges apart.
    const auto before = [](const dvec3& a, const dvec3& b) {
        return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
    };
    const auto edgeBefore = [&](const auto& a, const auto& b) {
        if (before(a.first, b.first) || before(b.first, a.first)) return before(a.first, b.first);
        return before(a.second, b.second);
    };
    std::map<std::pair<dvec3, dvec3>, Edge, decltype(edgeBefore)> edges(edgeBefore);
    for (const uvec3& triangle : object.mesh->triangles) {
        const dvec3 corners[] = {positionsWorld[triangle.x], positionsWorld[triangle.y], positionsWorld[triangle.z]};
        const dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        if (across == dvec3(0)) continue;
        const dvec3 normal = glm::normalize(across);
        for (int i = 0; i < 3; ++i) {
            dvec3 a = corners[i], b = corners[(i + 1) % 3];
            if (before(b, a)) std::swap(a, b);
            Edge& edge = edges[{a, b}];
            edge.isCrease = edge.isCrease || (edge.faces > 0 && glm::dot(edge.normal, normal) < kCreaseCosine);
            edge.normal = normal;
            ++edge.faces;
            edge.front += glm::dot(normal, dvec3(viewerWorld) - viewerWorld.w * a) > 0;
        }
    }
    std::vector<dvec3> drawn;
    for (const auto& [ends, edge] : edges) {
        const bool isOutline = edge.front > 0 && edge.front < edge.faces;
        if (edge.faces == 1 || isOutline || (edge.isCrease && edge.front > 0))
            drawn.insert(drawn.end(), {ends.first, ends.second});
    }
    return drawn;
}

void drawObject(drawing::Drawing& drawing, const drawing::Box& area, const ParallelView& view, const scene::Object& object,
                const drawing::Stroke& stroke, drawing::Labels* labels) {
    std::vector<dvec2> segments;
    const std::vector<dvec3> edges = drawnEdgesWorld(object, dvec4(view.towardViewerWorld(), 0));
    for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
        const dvec2 a = view(edges[i]), b = view(edges[i + 1]);
        if (!area.overlaps({glm::min(a, b) - 1.0, glm::abs(a - b) + 2.0})) continue;
        segments.insert(segments.end(), {a, b});
        if (labels) labels->avoid(a, b);
    }
    drawing.beginClip(area.corner, area.size);
    drawing.segments(segments, stroke);
    drawing.endClip();
}

} // namespace shadowlab::figures
