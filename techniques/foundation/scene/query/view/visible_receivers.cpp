// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/view/visible_receivers.h"

#include <array>

#include "techniques/foundation/scene/query/view/clip_polygon.h"
#include "techniques/foundation/scene/query/view/picture_part.h"

namespace shadowlab::scene {

namespace {

// For floors and walls the triangles are tested, because the box around a slanting one would be mostly empty.
constexpr std::size_t kFewTriangles = 16;

using Planes = std::array<dvec4, 5>;

void includeVisible(Bounds& visible, std::vector<dvec4> polygonWorld, const Planes& planes) {
    for (const dvec4& plane : planes)
        polygonWorld = clippedPolygon(polygonWorld, plane);
    for (const dvec4& corner : polygonWorld)
        visible.include(dvec3(corner));
}

Bounds visibleOfTriangles(const Object& object, const Planes& planes) {
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    Bounds visible;
    for (const uvec3& t : object.mesh->triangles) {
        std::vector<dvec4> polygon;
        for (const std::uint32_t v : {t.x, t.y, t.z})
            polygon.push_back(worldFromMesh * dvec4(dvec3(object.mesh->positionsMesh[v]), 1.0));
        includeVisible(visible, std::move(polygon), planes);
    }
    return visible;
}

/// For a box without the eye in it: the bounds of the visible parts of its sides.
Bounds visibleOfBox(const Bounds& box, const Planes& planes) {
    Bounds visible;
    for (int face = 0; face < 6; ++face)
        includeVisible(visible, boxFaceWorld(box, face), planes);
    return visible;
}

bool isInsidePlanes(const Bounds& box, const Planes& planes) {
    for (const dvec4& plane : planes)
        for (int i = 0; i < 8; ++i)
            if (glm::dot(plane, dvec4(box.corner(i), 1.0)) < 0) return false;
    return true;
}

/// At most `most` boxes, each around a run of the given ones, because objects that follow each other in a scene are mostly
/// near each other.
std::vector<Bounds> merged(std::vector<Bounds> boxes, std::size_t most) {
    if (boxes.size() <= most) return boxes;
    std::vector<Bounds> fewer(most);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        fewer[i * most / boxes.size()].include(boxes[i]);
    return fewer;
}

} // namespace

std::vector<Bounds> visibleReceivers(const Scene& scene, std::span<const Bounds> bounds, const dmat4& clipFromWorld,
                                     const PicturePart& part, std::size_t most) {
    const Planes planes = planesWorld(clipFromWorld, part);
    std::vector<Bounds> receivers;
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const Object& object = scene.objects[o];
        if (!object.receivesShadow || !mayTouch(bounds[o], clipFromWorld, part)) continue;
        if (isInsidePlanes(bounds[o], planes)) {
            receivers.push_back(bounds[o]);
            continue;
        }
        const Bounds visible = object.mesh->triangles.size() <= kFewTriangles ? visibleOfTriangles(object, planes)
                               : isBeyondNearPlane(bounds[o], clipFromWorld)  ? visibleOfBox(bounds[o], planes)
                                                                              : bounds[o];
        if (!visible.isEmpty()) receivers.push_back(visible);
    }
    return merged(std::move(receivers), most);
}

} // namespace shadowlab::scene
