// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/coincident/coincident_faces.h"

#include <algorithm>
#include <mutex>
#include <set>

#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/query/coincident/outward_shells.h"
#include "techniques/foundation/scene/query/coincident/placed_triangle.h"
#include "techniques/foundation/scene/query/coincident/touching_boxes.h"

namespace shadowlab::scene {

namespace {

/// Triangles of several objects, with the places they have.
struct Gathered {
    std::vector<std::uint32_t> triangles; ///< within their objects
    std::vector<PlacedTriangle> placed;
    std::vector<Bounds> boxes;

    /// Those of the object that touch the box.
    void add(const Object& object, const Bounds& within) {
        const TrianglePlacer place(object);
        for (std::uint32_t t = 0; t < object.mesh->triangles.size(); ++t) {
            const PlacedTriangle triangle = place(t);
            if (!touch(triangle.box, within)) continue;
            triangles.push_back(t);
            placed.push_back(triangle);
            boxes.push_back(triangle.box);
        }
    }
};

Bounds common(const Bounds& a, const Bounds& b) {
    return {glm::max(a.lowerWorld, b.lowerWorld), glm::min(a.upperWorld, b.upperWorld)};
}

/// Rules 1 and 2 (coincident_faces.h), of a side of a surface.
int rankOf(const Object& object, const Material& material, bool isFront) {
    const int shining = material.emission == vec3(0.0f)   ? 1
                        : !shinesFrom(material, isFront)  ? 0
                        : object.emitterOfLight >= 0      ? 3
                                                          : 2;
    return 2 * shining + (isFront ? 1 : 0);
}

} // namespace

CoincidentFaces::CoincidentFaces(const Scene& scene, const CoincidentFaces* before) : revisions_(scene.revisions) {
    findWithinMeshes(scene, before);
    findBetweenObjects(scene, before);
    numberPairs(scene);
    if (!pairs_.empty()) flagTriangles(scene);
}

void CoincidentFaces::findWithinMeshes(const Scene& scene, const CoincidentFaces* before) {
    for (const Object& object : scene.objects) {
        std::shared_ptr<const WithinMesh>& within = withinMeshes_[object.mesh];
        if (within) continue;
        if (before)
            if (const auto known = before->withinMeshes_.find(object.mesh); known != before->withinMeshes_.end()) {
                within = known->second;
                continue;
            }
        Object unmoved; // where a mesh stands does not matter to what coincides in it
        unmoved.mesh = object.mesh;
        const TrianglePlacer place(unmoved);
        std::vector<Bounds> boxes;
        std::vector<vec3> normals;
        boxes.reserve(object.mesh->triangles.size());
        normals.reserve(object.mesh->triangles.size());
        for (std::uint32_t t = 0; t < object.mesh->triangles.size(); ++t) {
            const PlacedTriangle placed = place(t);
            boxes.push_back(placed.box);
            normals.push_back(roughNormal(placed));
        }
        auto contacts = std::make_shared<WithinMesh>();
        std::vector<std::pair<std::uint32_t, std::uint32_t>> turnedOver;
        forEachTouchingPair(boxes, [&](std::uint32_t i, std::uint32_t j) {
            if (!mayBeParallel(normals[i], normals[j])) return;
            const PlacedTriangle a = place(i), b = place(j);
            if (!coincide(a, b)) return;
            const bool faceAlike = glm::dot(a.normal, b.normal) > 0;
            contacts->found.push_back({i, j, faceAlike, gapBetween(a, b)});
            if (!faceAlike) turnedOver.emplace_back(i, j);
        });
        if (!turnedOver.empty()) contacts->inOuterSkin = inOutwardShell(*object.mesh, turnedOver);
        within = std::move(contacts);
    }
}

void CoincidentFaces::findBetweenObjects(const Scene& scene, const CoincidentFaces* before) {
    std::vector<Bounds> boxes = objectBounds(scene);
    for (std::size_t o = 0; o < boxes.size(); ++o) {
        const double rounding = TrianglePlacer(scene.objects[o]).rounding();
        boxes[o] = {boxes[o].lowerWorld - rounding, boxes[o].upperWorld + rounding};
    }
    forEachTouchingPair(boxes, [&](std::uint32_t a, std::uint32_t b) {
        const Object &first = scene.objects[a], &second = scene.objects[b];
        BetweenObjects& between = betweenObjects_[{a, b}];
        between = {{first.mesh, first.worldFromObject}, {second.mesh, second.worldFromObject}, nullptr};
        if (before)
            if (const auto known = before->betweenObjects_.find({a, b});
                known != before->betweenObjects_.end() && known->second.first == between.first &&
                known->second.second == between.second) {
                between.found = known->second.found;
                return;
            }
        Gathered both;
        both.add(first, common(boxes[a], boxes[b]));
        const std::size_t ofFirst = both.triangles.size();
        both.add(second, common(boxes[a], boxes[b]));
        std::vector<Found> found;
        forEachTouchingPair(both.boxes, [&](std::uint32_t i, std::uint32_t j) {
            if (i >= ofFirst || j < ofFirst || !coincide(both.placed[i], both.placed[j])) return;
            const bool mirrored = isMirrored(first) != isMirrored(second);
            found.push_back({both.triangles[i], both.triangles[j],
                             (glm::dot(both.placed[i].normal, both.placed[j].normal) > 0) != mirrored,
                             gapBetween(both.placed[i], both.placed[j])});
        });
        between.found = std::make_shared<std::vector<Found>>(std::move(found));
    });
}

void CoincidentFaces::numberPairs(const Scene& scene) {
    std::vector<std::uint32_t> firstOfObject{0};
    for (const Object& object : scene.objects)
        firstOfObject.push_back(firstOfObject.back() + static_cast<std::uint32_t>(object.mesh->triangles.size()));
    const auto add = [&](const Found& found, std::size_t a, std::size_t b) {
        const std::uint32_t i = firstOfObject[a] + found.triangle, j = firstOfObject[b] + found.other;
        pairs_.push_back({i, j, found.faceAlike, found.gap});
        pairs_.push_back({j, i, found.faceAlike, found.gap});
    };
    for (std::size_t o = 0; o < scene.objects.size(); ++o)
        for (const Found& found : withinMeshes_.at(scene.objects[o].mesh)->found)
            add(found, o, o);
    for (const auto& [objects, between] : betweenObjects_)
        for (const Found& found : *between.found)
            add(found, objects.first, objects.second);
    if (pairs_.empty()) return;
    std::ranges::sort(pairs_);
    flags_.resize(firstOfObject.back());
    listTriangles(scene, firstOfObject);
}

void CoincidentFaces::listTriangles(const Scene& scene, std::span<const std::uint32_t> firstOfObject) {
    for (const Pair& pair : pairs_) {
        if (!triangles_.empty() && triangles_.back().number == pair.triangle) continue;
        const auto behind = std::ranges::upper_bound(firstOfObject, pair.triangle);
        const auto o = static_cast<std::uint32_t>(behind - firstOfObject.begin()) - 1;
        const Object& object = scene.objects[o];
        const std::uint32_t inObject = pair.triangle - firstOfObject[o];
        const Material& material = materialOfTriangle(scene, object, inObject);
        const std::vector<std::uint32_t>& fileOrder = object.mesh->fileOrder;
        triangles_.push_back({pair.triangle, o, inObject, firstOfObject[o] + (fileOrder.empty() ? inObject : fileOrder[inObject]),
                              rankOf(object, material, true), rankOf(object, material, false)});
    }
}

bool CoincidentFaces::isInner(const Scene& scene, const Object& object, bool isFront) {
    return !isFront && object.mesh->outward && !hasHoles(scene, object);
}

void CoincidentFaces::flagTriangles(const Scene& scene) {
    std::set<std::uint32_t> bodies; // objects
    for (const Pair& pair : pairs_) {
        std::uint8_t& flags = flags_[pair.triangle];
        flags |= together;
        if (pair.gap > 0) flags |= uneven;
        const std::uint32_t o = triangle(pair.other).object;
        const Object& other = scene.objects[o];
        // An eye that sees a front of this one sees the other's front if they face alike, else its back.
        const bool mirrored = isMirrored(scene.objects[triangle(pair.triangle).object]);
        if (!isInner(scene, other, pair.faceAlike)) flags |= mirrored ? back : front;
        if (!isInner(scene, other, !pair.faceAlike)) flags |= mirrored ? front : back;
        if (isInner(scene, other, false)) bodies.insert(o);
        anyUneven_ = anyUneven_ || (flags & uneven) != 0;
        anyShown_ = anyShown_ || (flags & (front | back)) != 0;
    }
    for (const std::uint32_t body : bodies)
        bodies_.push_back(boundsWorld(scene.objects[body]));
}

std::shared_ptr<const CoincidentFaces> CoincidentFaces::of(const Scene& scene) {
    static std::mutex mutex;
    static std::weak_ptr<const CoincidentFaces> last;
    const std::scoped_lock lock(mutex);
    const std::shared_ptr<const CoincidentFaces> before = last.lock();
    const auto isOf = [&](const Revisions& a, const Revisions& b) {
        return a.geometry == b.geometry && a.transforms == b.transforms && a.materials == b.materials;
    };
    if (before && isOf(before->revisions_, scene.revisions)) return before;
    const auto found = std::make_shared<const CoincidentFaces>(scene, before.get());
    last = found;
    return found;
}

std::span<const CoincidentFaces::Pair> CoincidentFaces::of(std::uint32_t triangle) const {
    const auto range = std::ranges::equal_range(pairs_, triangle, {}, &Pair::triangle);
    return {range.begin(), range.end()};
}

bool CoincidentFaces::areTogether(std::uint32_t triangle, std::uint32_t other) const {
    if (!touches(triangle) || !touches(other)) return false;
    const std::span<const Pair> pairs = of(triangle);
    const auto found = std::ranges::lower_bound(pairs, other, {}, &Pair::other);
    return found != pairs.end() && found->other == other;
}

bool CoincidentFaces::isWithinBody(const dvec3& positionWorld) const {
    return std::ranges::any_of(bodies_, [&](const Bounds& body) {
        return glm::all(glm::greaterThanEqual(positionWorld, body.lowerWorld)) &&
               glm::all(glm::lessThanEqual(positionWorld, body.upperWorld));
    });
}

const CoincidentFaces::Triangle& CoincidentFaces::triangle(std::uint32_t number) const {
    return *std::ranges::lower_bound(triangles_, number, {}, &Triangle::number);
}

} // namespace shadowlab::scene
