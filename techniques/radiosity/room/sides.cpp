// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/sides.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace shadowlab::radiosity {

namespace {

/// The same face seen from behind.
Face turned(const Face& face) {
    Face back = face;
    back.polygon = {};
    for (std::size_t i = face.polygon.count(); i-- > 0;)
        back.polygon.add(face.polygon[i]);
    back.plane.normal = -face.plane.normal;
    return back;
}

/// Does the face shine into the inside of the box? Its middle is looked at from a little before it: it may lie in a side of the box.
bool shinesInto(const Face& face, const scene::Material& material, bool isMirrored, const trace::CentredBox& box) {
    const dvec3 middle = centroid(face.polygon);
    const dvec3 step = kTouching * glm::length(box.upper - box.lower) * face.plane.normal;
    const auto isWithin = [&](const dvec3& p) {
        return glm::all(glm::greaterThan(p, box.lower)) && glm::all(glm::lessThan(p, box.upper));
    };
    return (scene::shinesFrom(material, !isMirrored) && isWithin(middle + step)) ||
           (scene::shinesFrom(material, isMirrored) && isWithin(middle - step)) ||
           (material.emission != vec3(0.0f) && std::ranges::any_of(face.polygon.corners(), isWithin));
}

/// For each object: can the inside of its surface be bright and visible?
std::vector<bool> openObjects(const scene::Scene& scene, const trace::WorldTriangles& world, const Faces& faces,
                              const std::vector<bool>& lightWithin) {
    std::vector<trace::CentredBox> boxes(scene.objects.size());
    for (std::size_t t = 0; t < world.triangles.size(); ++t)
        for (const dvec3& corner : {world.triangles[t].a, world.triangles[t].b, world.triangles[t].c})
            boxes[world.objects[t]].include(corner);
    std::vector<bool> open;
    for (std::uint32_t o = 0; o < scene.objects.size(); ++o) {
        const scene::Object& object = scene.objects[o];
        const auto shinesWithin = [&](const Face& face) {
            return shinesInto(face, scene.materials[face.material], scene::isMirrored(scene.objects[face.object]),
                              boxes[o]);
        };
        // An object that casts no shadow lets light in from outside.
        open.push_back(!object.mesh->outward || !object.castsShadow || lightWithin[o] ||
                       std::ranges::any_of(faces.all, shinesWithin));
    }
    return open;
}

/// For each face the one of the same object at the same place that faces the other way, or kNoFace: simplification may bring the
/// two sides of a thin sheet together.
std::vector<std::uint32_t> opposites(const Faces& faces) {
    using Corner = std::array<double, 3>;
    std::map<std::pair<std::uint32_t, std::vector<Corner>>, std::uint32_t> alone; ///< by object and sorted corners
    std::vector<std::uint32_t> opposite(faces.all.size(), kNoFace);
    for (std::uint32_t number = 0; number < faces.all.size(); ++number) {
        const Face& face = faces.all[number];
        std::vector<Corner> corners;
        for (const dvec3& corner : face.polygon.corners())
            corners.push_back({corner.x, corner.y, corner.z});
        std::ranges::sort(corners);
        const auto [entry, isNew] = alone.try_emplace({face.object, std::move(corners)}, number);
        const std::uint32_t other = entry->second;
        if (isNew || glm::dot(face.plane.normal, faces.all[other].plane.normal) > 0) continue;
        opposite[number] = other;
        opposite[other] = number;
        alone.erase(entry);
    }
    return opposite;
}

/// Does any face reach before the plane of this side?
bool seesAnything(const Face& side, const Faces& plain) {
    return std::ranges::any_of(plain.all, [&](const Face& other) {
        return !isBehind(side.plane, other.polygon, kTouching * (sizeOf(other.polygon) + sizeOf(side.polygon)));
    });
}

} // namespace

Sides sidesOf(const scene::Scene& scene, const trace::WorldTriangles& world, const Faces& plain,
              const std::vector<bool>& lightWithin) {
    Sides sides;
    sides.faces.ofTriangle.assign(plain.ofTriangle.size(), kNoFace);
    sides.backOfTriangle = sides.faces.ofTriangle;
    const std::vector<bool> open = openObjects(scene, world, plain, lightWithin);
    for (const bool isOpen : open)
        sides.isClosed.push_back(!isOpen);
    struct Loose {
        Face side;
        bool isBack;
    };
    std::vector<Loose> loose;
    const auto add = [&](const Face& side, bool isBack) {
        for (const std::uint32_t triangle : side.triangles)
            (isBack ? sides.backOfTriangle : sides.faces.ofTriangle)[triangle] =
                static_cast<std::uint32_t>(sides.faces.all.size());
        sides.faces.all.push_back(side);
    };
    const std::vector<std::uint32_t> opposite = opposites(plain);
    // All fronts first, then all backs: so in most scenes the numbers of fronts are those of their faces.
    for (const bool isBack : {false, true})
        for (std::size_t number = 0; number < plain.all.size(); ++number) {
            const Face& face = plain.all[number];
            // If a matrix turns a body inside out, its outside is the back.
            if (!open[face.object] && isBack != scene::isMirrored(scene.objects[face.object])) continue;
            if (open[face.object] && isBack && opposite[number] != kNoFace)
                continue; // the opposite face's front; set below
            Face side = isBack ? turned(face) : face;
            // Where two faces have come together, each side stands for the front of one of them.
            side.isFront = isBack == scene::isMirrored(scene.objects[face.object]) || opposite[number] != kNoFace;
            side.shines = scene::shinesFrom(scene.materials[face.material], side.isFront);
            if (seesAnything(side, plain))
                add(side, isBack);
            else
                loose.push_back({side, isBack});
        }
    sides.exchanging = sides.faces.all.size();
    for (const auto& [side, isBack] : loose)
        add(side, isBack);
    for (std::size_t number = 0; number < plain.all.size(); ++number) {
        if (!open[plain.all[number].object] || opposite[number] == kNoFace) continue;
        const std::uint32_t back = sides.faces.ofTriangle[plain.all[opposite[number]].triangles[0]];
        for (const std::uint32_t triangle : plain.all[number].triangles)
            sides.backOfTriangle[triangle] = back;
    }
    return sides;
}

} // namespace shadowlab::radiosity
