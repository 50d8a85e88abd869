// The lecture's "Methods to Speed up Ray-Tracing Calculations": "most calculation time of ray-tracing algorithm is spent on
// ray-surface intersection calculations", so most of them are avoided with a bounding volume tree.
//
// T. Moeller and B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997. S. Rubin and T. Whitted, "A 3-Dimensional
// Representation for Fast Rendering of Complex Scenes", 1980: trees of boxes. Simplified: triangles are halved by their number; a
// tree that weighs the boxes' areas is up to twice as fast.
// SPDX-License-Identifier: MIT
#include "techniques/lecture/parts/rays.h"

#include <algorithm>

#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/surface_color.h"
#include "techniques/foundation/scene/query/facing.h"

namespace shadowlab::lecture {

namespace {

// start + distance * u = (1 - b - c) A + b B + c C: three equations for distance, b and c, solved by Cramer's rule.
// [anchor: lecture-intersection]
bool intersects(const Ray& ray, const Triangle& triangle, Hit& hit) {
    constexpr double kEdge = -1e-12; // rounding: an edge belongs to both of its triangles, so that no ray slips through
    const dvec3 ab = triangle.bWorld - triangle.aWorld, ac = triangle.cWorld - triangle.aWorld;
    const dvec3 fromA = ray.startWorld - triangle.aWorld, p = glm::cross(ray.u, ac), q = glm::cross(fromA, ab);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0) return false; // the ray is parallel to the triangle
    const double inverse = 1 / determinant;
    hit = {&triangle, glm::dot(ac, q) * inverse, glm::dot(fromA, p) * inverse, glm::dot(ray.u, q) * inverse};
    const bool inside = hit.b >= kEdge && hit.c >= kEdge && 1 - hit.b - hit.c >= kEdge;
    return inside && hit.distance > ray.nearest && hit.distance < ray.farthest;
}

// Between each pair of the box's planes the ray lies from one distance to another; within the box, where all three do.
// [anchor: lecture-bounding-volume]
bool intersects(const Ray& ray, const dvec3& inverseU, const scene::Bounds& box) {
    double enters = ray.nearest, leaves = ray.farthest;
    for (int axis = 0; axis < 3; ++axis) {
        double near = (box.lowerWorld[axis] - ray.startWorld[axis]) * inverseU[axis];
        double far = (box.upperWorld[axis] - ray.startWorld[axis]) * inverseU[axis];
        if (near > far) std::swap(near, far);
        if (near > enters) enters = near; // both comparisons are false for 0 * infinity: a ray within the plane
        if (far < leaves) leaves = far;
    }
    return enters <= leaves + kContact; // a flat box is left where it is entered, give or take rounding
}

int longestAxis(const scene::Bounds& box) {
    const dvec3 size = box.upperWorld - box.lowerWorld;
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

// "Enclose several smaller bounding volumes with a larger bounding volume to form a hierarchical tree structure."
// [anchor: lecture-bounding-volume-tree]
std::unique_ptr<BoundingVolume> enclose(std::span<const Triangle*> triangles) {
    constexpr std::size_t kFew = 4; // to try them takes about as long as to look at two more boxes
    auto volume = std::make_unique<BoundingVolume>(BoundingVolume{{}, triangles});
    for (const Triangle* t : triangles)
        for (const dvec3& corner : {t->aWorld, t->bWorld, t->cWorld})
            volume->box.include(corner);
    if (triangles.size() <= kFew) return volume;
    const std::size_t half = triangles.size() / 2;
    const auto along = [axis = longestAxis(volume->box)](const Triangle* t) {
        return t->aWorld[axis] + t->bWorld[axis] + t->cWorld[axis];
    };
    std::ranges::nth_element(triangles, triangles.begin() + static_cast<std::ptrdiff_t>(half), {}, along);
    volume->first = enclose(triangles.first(half));
    volume->second = enclose(triangles.subspan(half));
    return volume;
}

/// `tries(triangle)` for those that the ray may meet, until it answers true. Each hit that it finds may shorten the ray.
// "The intersection test is done by processing the tree in top-down order."
// [anchor: lecture-top-down]
template <typename Tries>
bool descend(const Ray& ray, const dvec3& inverseU, const BoundingVolume& volume, const Tries& tries) {
    if (!intersects(ray, inverseU, volume.box)) return false;
    if (!volume.first) return std::ranges::any_of(volume.triangles, tries);
    const bool firstIsNearer = ray.u[longestAxis(volume.box)] >= 0;
    const BoundingVolume& near = firstIsNearer ? *volume.first : *volume.second;
    const BoundingVolume& far = firstIsNearer ? *volume.second : *volume.first;
    return descend(ray, inverseU, near, tries) || descend(ray, inverseU, far, tries);
}

bool isCounterClockwise(const Triangle& t, const Ray& ray) {
    return glm::dot(glm::cross(t.bWorld - t.aWorld, t.cWorld - t.aWorld), ray.u) < 0;
}

} // namespace

std::optional<Surface> RayScene::firstSurface(const Ray& ray) const {
    Ray shortened = ray;
    Hit nearest, hit;
    descend(shortened, 1.0 / ray.u, *all_, [&](const Triangle* t) {
        if (isLeft(*t, ray) || !intersects(shortened, *t, hit)) return false;
        if (scene::isInHole(scene(), objectOf(*t), t->inObject, {1 - hit.b - hit.c, hit.b, hit.c})) return false;
        nearest = hit;
        shortened.farthest = hit.distance;
        return false; // a nearer one may come
    });
    if (!nearest.triangle) return std::nullopt;
    return surfaceAt(ray, seenInPlaceOf(nearest, ray));
}

/// Faces may coincide: of those at one place one is seen (scene/query/coincident/coincident_faces.h).
Hit RayScene::seenInPlaceOf(const Hit& nearest, const Ray& ray) const {
    const Triangle& first = *nearest.triangle;
    if (!coincident_->touches(first.number)) return nearest;
    const bool isWithin = coincident_->isWithinBody(ray.startWorld);
    if (!coincident_->mayShowAnother(first.number, isCounterClockwise(first, ray), isWithin)) return nearest;
    Hit seen = nearest, hit;
    descend(ray, 1.0 / ray.u, *all_, [&](const Triangle* t) {
        if (coincident_->areTogether(first.number, t->number) && rankOf(*seen.triangle, ray) < rankOf(*t, ray) && !isLeft(*t, ray) &&
            intersects(ray, *t, hit) && !scene::isInHole(scene(), objectOf(*t), t->inObject, {1 - hit.b - hit.c, hit.b, hit.c}))
            seen = hit;
        return false; // others may go before it
    });
    return seen;
}

scene::SideRank RayScene::rankOf(const Triangle& t, const Ray& ray) const { return coincident_->rank(t.number, isFront(t, ray)); }

/// Does the ray begin on the triangle, or on one in the same plane, but for rounding?
bool RayScene::isLeft(const Triangle& t, const Ray& ray) const {
    if (&t == ray.leaves) return true;
    return ray.leaves && coincident_->isUneven(t.number) && coincident_->areTogether(ray.leaves->number, t.number);
}

/// Does the ray see the side with the corners counter-clockwise? Of an object that is mirrored, the mesh has them the other way round.
bool RayScene::isFront(const Triangle& t, const Ray& ray) const {
    return isCounterClockwise(t, ray) != scene::isMirrored(objectOf(t));
}

bool RayScene::isBlocked(const Ray& ray, int light) const {
    Hit hit;
    return descend(ray, 1.0 / ray.u, *all_, [&](const Triangle* t) { // any will do
        return !isLeft(*t, ray) && objectOf(*t).castsShadow && (light < 0 || lightSide(*t, light) != 0) &&
               intersects(ray, *t, hit) &&
               !scene::isInHole(scene(), objectOf(*t), t->inObject, {1 - hit.b - hit.c, hit.b, hit.c});
    });
}

bool RayScene::isFree(const Triangle& from, const dvec3& fromWorld, const dvec3& toWorld) const {
    constexpr double kBefore = 1 - 1e-6; // of the way: the line ends before it meets a surface there
    const double distance = glm::distance(fromWorld, toWorld);
    return !isBlocked({fromWorld, (toWorld - fromWorld) / distance, kContact, kBefore * distance, &from});
}

Surface RayScene::surfaceAt(const Ray& ray, const Hit& hit) const {
    const Triangle& t = *hit.triangle;
    const scene::Object& object = objectOf(t);
    const auto at = [&hit](const dvec3& A, const dvec3& B, const dvec3& C) {
        return (1 - hit.b - hit.c) * A + hit.b * B + hit.c * C;
    };
    const std::vector<vec3>& normals = object.mesh->normalsMesh;
    const uvec3 corners = object.mesh->triangles[t.inObject];
    const dmat3 normalWorldFromMesh = glm::transpose(glm::inverse(dmat3(object.worldFromObject)));
    const auto normalWorld = [&](std::uint32_t corner) {
        return glm::normalize(normalWorldFromMesh * dvec3(normals[corner]));
    };
    const dvec3 N = glm::normalize(at(normalWorld(corners.x), normalWorld(corners.y), normalWorld(corners.z)));
    return {at(t.aWorld, t.bWorld, t.cWorld),
            glm::dot(N, ray.u) > 0 ? -N : N,
            &scene().materials[t.material],
            dvec3(scene::diffuseAt(scene(), object, t.inObject, {1 - hit.b - hit.c, hit.b, hit.c})),
            &t,
            hit.distance,
            isFront(t, ray)};
}

vec3 RayScene::emissionAt(const Surface& surface) const {
    return scene::shinesFrom(*surface.material, surface.onFront) ? surface.material->emission : vec3(0.0f);
}

RayScene::RayScene(const scene::Snapshot& snapshot) : snapshot_(snapshot) {
    for (std::uint32_t object = 0; object < scene().objects.size(); ++object) {
        const scene::Mesh& mesh = *scene().objects[object].mesh;
        const dmat4 worldFromMesh = scene::worldFromMesh(scene().objects[object]);
        const auto corner = [&](std::uint32_t vertex) {
            return transformPoint(worldFromMesh, dvec3(mesh.positionsMesh[vertex]));
        };
        for (std::size_t part = 0; part < mesh.parts.size(); ++part)
            for (std::uint32_t i = 0; i < mesh.parts[part].triangleCount; ++i) {
                const std::uint32_t inObject = mesh.parts[part].firstTriangle + i;
                const uvec3 t = mesh.triangles[inObject];
                triangles_.push_back({corner(t.x), corner(t.y), corner(t.z), object, inObject,
                                      static_cast<std::uint32_t>(triangles_.size()),
                                      scene().objects[object].partMaterials[part]});
            }
    }
    for (const Triangle& t : triangles_)
        sorted_.push_back(&t);
    all_ = enclose(sorted_);
    coincident_ = scene::CoincidentFaces::of(scene());
    for (const scene::Light& light : scene().lights)
        facing_.push_back(scene::facingSigns(scene(), light));
}

} // namespace shadowlab::lecture
