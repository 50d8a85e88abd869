// SPDX-License-Identifier: MIT
#include "techniques/planar/casters.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/gl/scene/scene_buffers.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/foundation/scene/query/facing.h"
#include "techniques/foundation/scene/query/lamp_plane.h"

namespace shadowlab::planar {

bool isWithin(const dvec4& lightWorld, const Caster& caster) {
    if (lightWorld.w <= 0) return false;
    const dvec3 lower = caster.boundsWorld.lowerWorld, upper = caster.boundsWorld.upperWorld;
    // Far more than the rounding of double, and of vertices, which are floats.
    const dvec3 margin = 1e-6 * (upper - lower + glm::max(glm::abs(lower), glm::abs(upper)));
    return glm::all(glm::lessThanEqual(lower - margin, dvec3(lightWorld))) &&
           glm::all(glm::lessThanEqual(dvec3(lightWorld), upper + margin));
}

std::vector<NearTriangle> trianglesNear(const dvec4& lightWorld, const Caster& caster, const scene::Object& object,
                                        const scene::Light& light) {
    // What the graphics card computes with floats is off by no more than this share of the largest distance.
    constexpr double kFloats = 1.0 / (1 << 20);
    // Nearer than this the light lies in the triangle, and on no side: contact, as for rays (docs/conventions.md).
    constexpr double kContact = 1e-10;
    const dvec3 lightMesh =
        glm::inverse(dmat3(caster.worldFromMesh)) * (dvec3(lightWorld) - dvec3(caster.worldFromMesh[3]));
    const double reach = glm::length(caster.farthestMesh) + glm::length(lightMesh);
    std::vector<NearTriangle> found;
    const scene::Mesh& mesh = *object.mesh;
    const std::vector<std::uint8_t> inPlane = scene::inLampPlane(object, light);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const uvec3& corners = mesh.triangles[t];
        const dvec3 a(mesh.positionsMesh[corners.x]), b(mesh.positionsMesh[corners.y]),
            c(mesh.positionsMesh[corners.z]);
        const dvec3 cross = glm::cross(b - a, c - a);
        const double size = glm::length(cross);
        if (size <= 0) continue;
        const dvec3 normal = cross / size;
        const double height = glm::dot(normal, lightMesh - a);
        if (std::abs(height) > kFloats * reach) continue;
        NearTriangle near{t, false, dvec4(0.0)};
        const std::int8_t side = scene::facingSign(a, b, c, dvec4(lightMesh, 1.0));
        if (side != 0 && (inPlane.empty() || !inPlane[t]) && std::abs(height) > kContact * reach) {
            const auto inside = [&](const dvec3& from, const dvec3& to) {
                return glm::dot(glm::cross(to - from, lightMesh - from), normal) >= 0;
            };
            near.holdsLight = inside(a, b) && inside(b, c) && inside(c, a);
            const dvec3 normalWorld = static_cast<double>(side) * transformNormal(caster.worldFromMesh, normal);
            near.planeWorld = dvec4(normalWorld, -glm::dot(normalWorld, transformPoint(caster.worldFromMesh, a)));
        }
        found.push_back(near);
    }
    return found;
}

void Casters::update(const scene::Snapshot& snapshot) {
    const scene::Revisions& now = snapshot->revisions;
    if (made_.geometry == now.geometry && made_.transforms == now.transforms && made_.materials == now.materials)
        return;
    made_ = now;
    listRevision_ = scene::newRevision();
    casters_.clear();
    positionsCaster_.clear();
    triangles_.clear();
    farthestInList_ = dvec3(0.0);
    for (const std::size_t o : scene::allCasters(*snapshot)) {
        const scene::Object& object = snapshot->objects[o];
        Caster caster;
        caster.object = o;
        caster.hasHoles = scene::hasHoles(*snapshot, object);
        caster.mirrored = scene::isMirrored(object);
        caster.worldFromMesh = scene::worldFromMesh(object);
        caster.outward = object.mesh->outward && !caster.hasHoles;
        caster.boundsWorld = scene::boundsWorld(object);
        casters_.push_back(caster);
    }
    std::ranges::stable_partition(casters_, [](const Caster& caster) { return caster.outward; });
    chooseList();
    for (Caster& caster : casters_)
        add(snapshot->objects[caster.object], caster);
}

/// Leaves out casters far from the middle until all in the list are near it; the unit is the size of a typical caster.
void Casters::chooseList() {
    std::vector<double> sizes;
    for (Caster& caster : casters_) {
        caster.inList = !caster.hasHoles && !caster.boundsWorld.isEmpty();
        if (caster.inList) sizes.push_back(glm::length(caster.boundsWorld.upperWorld - caster.boundsWorld.lowerWorld));
    }
    if (sizes.empty()) return;
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>((sizes.size() - 1) / 2);
    std::ranges::nth_element(sizes, middle);
    for (;;) {
        scene::Bounds all;
        for (const Caster& caster : casters_)
            if (caster.inList) all.include(caster.boundsWorld);
        if (all.isEmpty()) return;
        const dvec3 originWorld = 0.5 * (all.lowerWorld + all.upperWorld);
        worldFromCaster_ = dmat4(1.0);
        worldFromCaster_[3] = dvec4(originWorld, 1.0);
        const double reach = 0.5 * glm::length(all.upperWorld - all.lowerWorld);
        if (reach <= kFarthestInSizes * *middle) return;
        for (Caster& caster : casters_) {
            const dvec3 farthest = glm::max(glm::abs(caster.boundsWorld.lowerWorld - originWorld),
                                            glm::abs(caster.boundsWorld.upperWorld - originWorld));
            if (glm::length(farthest) > 0.5 * reach) caster.inList = false;
        }
    }
}

void Casters::add(const scene::Object& object, Caster& caster) {
    const scene::Mesh& mesh = *object.mesh;
    for (const vec3& position : mesh.positionsMesh)
        caster.farthestMesh = glm::max(caster.farthestMesh, dvec3(glm::abs(position)));
    if (!caster.inList) return;
    caster.triangleCount = static_cast<std::uint32_t>(mesh.triangles.size());
    caster.firstTriangle = static_cast<std::uint32_t>(triangles_.size());
    const auto firstVertex = static_cast<std::uint32_t>(positionsCaster_.size());
    for (const vec3& position : mesh.positionsMesh) {
        const dvec3 positionCaster = transformPoint(caster.worldFromMesh, dvec3(position)) - dvec3(worldFromCaster_[3]);
        caster.farthestCaster = glm::max(caster.farthestCaster, glm::abs(positionCaster));
        positionsCaster_.emplace_back(positionCaster);
    }
    farthestInList_ = glm::max(farthestInList_, caster.farthestCaster);
    for (const uvec3& t : mesh.triangles)
        triangles_.push_back(firstVertex + (caster.mirrored ? uvec3(t.x, t.z, t.y) : t));
}

namespace {

const void* byteOffset(std::uint32_t triangle) {
    return reinterpret_cast<const void*>(std::uintptr_t{triangle} * sizeof(uvec3)); // GL takes offsets as pointers
}

} // namespace

void DrawList::add(const Caster& caster) {
    const auto count = static_cast<GLsizei>(3 * caster.triangleCount);
    if (!counts.empty()) {
        const auto end = reinterpret_cast<std::uintptr_t>(offsets.back()) +
                         static_cast<std::uintptr_t>(counts.back()) * sizeof(std::uint32_t);
        if (end == reinterpret_cast<std::uintptr_t>(byteOffset(caster.firstTriangle))) {
            counts.back() += count;
            return;
        }
    }
    counts.push_back(count);
    offsets.push_back(byteOffset(caster.firstTriangle));
}

void CasterBuffers::update(const Casters& casters) {
    if (listRevision_ == casters.listRevision()) return;
    listRevision_ = casters.listRevision();
    vertexArray_ = gl::VertexArrayHandle::create();
    glBindVertexArray(vertexArray_.id());
    positions_ = gl::uploadBuffer(GL_ARRAY_BUFFER, casters.positionsCaster());
    glVertexAttribPointer(gl::kPositionMesh, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(gl::kPositionMesh);
    indices_ = gl::uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, casters.triangles());
    glBindVertexArray(0);
}

void CasterBuffers::draw(const DrawList& list) const {
    glBindVertexArray(vertexArray_.id());
    glMultiDrawElements(GL_TRIANGLES, list.counts.data(), GL_UNSIGNED_INT, list.offsets.data(),
                        static_cast<GLsizei>(list.counts.size()));
    glBindVertexArray(0);
}

} // namespace shadowlab::planar
