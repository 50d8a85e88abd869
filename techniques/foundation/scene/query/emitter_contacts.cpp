// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/emitter_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "techniques/foundation/scene/query/mesh_rounding.h"

namespace shadowlab::scene {

namespace {

struct Corner {
    dvec3 positionWorld{0.0};
    dvec3 rounding{0.0}; ///< along each axis, metres
};

struct Placed {
    std::uint32_t number = 0;
    std::array<Corner, 3> corners;
    [[nodiscard]] Bounds bounds() const {
        Bounds box;
        for (const Corner& corner : corners) {
            box.include(corner.positionWorld - corner.rounding);
            box.include(corner.positionWorld + corner.rounding);
        }
        return box;
    }
    [[nodiscard]] dvec3 normal() const {
        return glm::cross(corners[1].positionWorld - corners[0].positionWorld,
                          corners[2].positionWorld - corners[0].positionWorld);
    }
};

bool touch(const Bounds& a, const Bounds& b) {
    return glm::all(glm::lessThanEqual(a.lowerWorld, b.upperWorld)) &&
           glm::all(glm::lessThanEqual(b.lowerWorld, a.upperWorld));
}

class PlacedObject {
public:
    explicit PlacedObject(const Object& object) : mesh_(*object.mesh), worldFromMesh_(scene::worldFromMesh(object)) {}
    [[nodiscard]] Placed triangle(std::uint32_t index, std::uint32_t firstOfObject) const {
        Placed placed;
        placed.number = firstOfObject + index;
        for (int i = 0; i < 3; ++i) {
            const dvec3 positionMesh(mesh_.positionsMesh[mesh_.triangles[index][i]]);
            Corner& corner = placed.corners[static_cast<std::size_t>(i)];
            corner.positionWorld = transformPoint(worldFromMesh_, positionMesh);
            dvec3 magnitudes(0.0);
            for (int axis = 0; axis < 3; ++axis)
                magnitudes += glm::abs(dvec3(worldFromMesh_[axis]) * positionMesh[axis]);
            corner.rounding = kFloatRounding * magnitudes +
                              kDoubleRounding * (glm::abs(dvec3(worldFromMesh_[3])) + glm::abs(corner.positionWorld));
        }
        return placed;
    }

private:
    const Mesh& mesh_;
    dmat4 worldFromMesh_;
};

/// Do all corners of `a` lie in the plane of `b`, but for rounding?
bool liesInPlane(const Placed& a, const Placed& b) {
    const dvec3 normal = b.normal();
    const double length = glm::length(normal);
    if (!(length > 0)) return false;
    const dvec3 unit = normal / length;
    dvec3 ofPlane(0.0);
    for (const Corner& corner : b.corners)
        ofPlane = glm::max(ofPlane, corner.rounding);
    return std::ranges::all_of(a.corners, [&](const Corner& corner) {
        const double height = glm::dot(unit, corner.positionWorld - b.corners[0].positionWorld);
        return std::abs(height) <= glm::dot(glm::abs(unit), corner.rounding + ofPlane);
    });
}

/// Of two triangles in one plane: do they share more than an edge? By separating lines along their edges.
bool overlap(const Placed& a, const Placed& b) {
    const dvec3 steep = glm::abs(a.normal());
    const int drop = steep.x > steep.y ? (steep.x > steep.z ? 0 : 2) : (steep.y > steep.z ? 1 : 2);
    const auto flat = [drop](const dvec3& p) { return dvec2(p[(drop + 1) % 3], p[(drop + 2) % 3]); };
    const auto isSeparated = [&](const Placed& first, const Placed& second) {
        for (std::size_t i = 0; i < 3; ++i) {
            const dvec2 from = flat(first.corners[i].positionWorld),
                        to = flat(first.corners[(i + 1) % 3].positionWorld);
            const dvec2 across(to.y - from.y, from.x - to.x);
            const auto beyond = [&](const Corner& corner) {
                return glm::dot(across, flat(corner.positionWorld) - from);
            };
            const double own = beyond(first.corners[(i + 2) % 3]);
            // Touching along an edge, or overlapping by rounding alone, is no overlap.
            const double slack =
                glm::dot(glm::abs(across), flat(first.corners[i].rounding + second.corners[0].rounding));
            if (std::ranges::all_of(second.corners, [&](const Corner& c) {
                    return own > 0 ? beyond(c) <= slack : beyond(c) >= -slack;
                }))
                return true;
        }
        return false;
    };
    return !isSeparated(a, b) && !isSeparated(b, a);
}

/// Triangles in the order in which their boxes begin along the axis in which they spread most: of many, few are near another one.
class SortedTriangles {
public:
    explicit SortedTriangles(std::vector<Placed> triangles) {
        for (const Placed& triangle : triangles)
            box_.include(triangle.bounds());
        const dvec3 size = box_.upperWorld - box_.lowerWorld;
        axis_ = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
        for (const Placed& triangle : triangles)
            entries_.push_back({triangle.bounds(), triangle});
        std::ranges::sort(entries_, {}, [this](const Entry& entry) { return entry.box.lowerWorld[axis_]; });
        for (const Entry& entry : entries_)
            longest_ = std::max(longest_, entry.box.upperWorld[axis_] - entry.box.lowerWorld[axis_]);
    }
    /// Empty where there are none.
    [[nodiscard]] const Bounds& box() const { return box_; }
    /// Calls `visit` with each triangle whose box touches this one.
    template <typename Visit>
    void near(const Bounds& box, const Visit& visit) const {
        const auto lower = [this](const Entry& entry) { return entry.box.lowerWorld[axis_]; };
        for (auto entry = std::ranges::lower_bound(entries_, box.lowerWorld[axis_] - longest_, {}, lower);
             entry != entries_.end() && lower(*entry) <= box.upperWorld[axis_]; ++entry)
            if (touch(entry->box, box)) visit(entry->triangle);
    }

private:
    struct Entry {
        Bounds box;
        Placed triangle;
    };
    std::vector<Entry> entries_;
    Bounds box_;
    int axis_ = 0;
    double longest_ = 0; ///< of all boxes, along the axis
};

} // namespace

EmitterContacts::EmitterContacts(const Scene& scene) {
    struct Part {
        std::size_t object, part;
        std::uint32_t firstOfObject;
    };
    std::vector<Part> all, emitters;
    std::uint32_t first = 0;
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const Object& object = scene.objects[o];
        firstPartOfObject_.push_back(all.size());
        for (std::size_t p = 0; p < object.partMaterials.size() && p < object.mesh->parts.size(); ++p) {
            all.push_back({o, p, first});
            if (scene.materials[object.partMaterials[p]].emission != vec3(0.0f)) emitters.push_back(all.back());
        }
        first += static_cast<std::uint32_t>(object.mesh->triangles.size());
    }
    firstPartOfObject_.push_back(all.size());
    if (emitters.empty()) return;
    const std::vector<Bounds> bounds = objectBounds(scene);
    const auto trianglesOf = [&](const Part& part, const Bounds& within) {
        const Object& object = scene.objects[part.object];
        const PlacedObject placed(object);
        const MeshPart& run = object.mesh->parts[part.part];
        std::vector<Placed> found;
        for (std::uint32_t i = 0; i < run.triangleCount; ++i) {
            const Placed triangle = placed.triangle(run.firstTriangle + i, part.firstOfObject);
            if (touch(triangle.bounds(), within)) found.push_back(triangle);
        }
        return found;
    };
    const Bounds everywhere{dvec3(-1e300), dvec3(1e300)};
    std::vector<bool> emitterParts(all.size());
    for (const Part& emitter : emitters) {
        const SortedTriangles shining(trianglesOf(emitter, everywhere));
        const Bounds& box = shining.box();
        if (box.isEmpty()) continue;
        for (const Part& other : all) {
            if (other.object == emitter.object && other.part == emitter.part) continue;
            Bounds grown = bounds[other.object];
            const dvec3 margin = 2 * kFloatRounding * (glm::abs(grown.lowerWorld) + glm::abs(grown.upperWorld));
            grown = {grown.lowerWorld - margin, grown.upperWorld + margin};
            if (!touch(grown, box)) continue;
            for (const Placed& face : trianglesOf(other, box))
                shining.near(face.bounds(), [&](const Placed& triangle) {
                    if (!(liesInPlane(triangle, face) || liesInPlane(face, triangle)) || !overlap(triangle, face)) return;
                    pairs_.push_back({triangle.number, face.number});
                    pairs_.push_back({face.number, triangle.number});
                    emitterParts[firstPartOfObject_[emitter.object] + emitter.part] = true;
                });
        }
    }
    if (pairs_.empty()) return;
    std::ranges::sort(pairs_);
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    emitterParts_ = std::move(emitterParts);
    flags_.resize(first);
    for (const Pair& pair : pairs_)
        flags_[pair.triangle] = true;
}

std::vector<std::uint32_t> EmitterContacts::of(std::uint32_t triangle) const {
    std::vector<std::uint32_t> others;
    for (auto pair = std::ranges::lower_bound(pairs_, triangle, {}, &Pair::triangle);
         pair != pairs_.end() && pair->triangle == triangle; ++pair)
        others.push_back(pair->other);
    return others;
}

bool EmitterContacts::hasEmitterInFace(std::size_t object) const {
    if (emitterParts_.empty()) return false;
    for (std::size_t part = firstPartOfObject_[object]; part < firstPartOfObject_[object + 1]; ++part)
        if (emitterParts_[part]) return true;
    return false;
}

int rankInContact(const Object& object, const Material& material, bool isFront) {
    if (material.emission == vec3(0.0f)) return 1;
    if (!shinesFrom(material, isFront)) return 0;
    return object.emitterOfLight >= 0 ? 3 : 2;
}

std::uint32_t seenOf(std::span<const SeenTriangle> together) {
    const auto isBefore = [](const SeenTriangle& a, const SeenTriangle& b) {
        return a.rank != b.rank ? a.rank > b.rank : a.number < b.number;
    };
    return std::ranges::min_element(together, isBefore)->number;
}

} // namespace shadowlab::scene
