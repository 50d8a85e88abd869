// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/scene/front_triangles.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/base/software.h"

namespace shadowlab::gl {

namespace {

// Measured (docs/performance.md): a frame with 10,000 triangles gains nothing but in its map, with fewer a list is not worth its buffers.
constexpr std::size_t kFewest = 4000;

// The least angle at which a triangle that is left out is seen from behind: its sine.
constexpr double kLeastSine = 1e-3;

// A viewer so much farther away than its own coordinates count for is a direction.
constexpr double kNoPoint = 1e-12;

} // namespace

bool paysToListFronts(const scene::Mesh& mesh) {
    return mesh.triangles.size() >= kFewest && isSoftware(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
}

dvec4 viewerMesh(const dmat4& clipFromMesh) {
    // What is projected to no place in the picture, and to no depth.
    const dvec4 center = glm::inverse(clipFromMesh) * dvec4(0, 0, 1, 0);
    if (std::abs(center.w) > kNoPoint * glm::length(dvec3(center))) return center / center.w;
    return {-glm::normalize(dvec3(center)), 0}; // that way depths grow
}

std::vector<std::uint32_t> frontTriangles(const scene::Mesh& mesh, const dvec4& viewerMesh) {
    std::vector<std::uint32_t> list(mesh.triangles.size());
    std::size_t kept = 0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const uvec3& corners = mesh.triangles[t];
        const dvec3 a = mesh.positionsMesh[corners.x];
        const dvec3 normal = glm::cross(dvec3(mesh.positionsMesh[corners.y]) - a, dvec3(mesh.positionsMesh[corners.z]) - a);
        const dvec3 toViewer = dvec3(viewerMesh) - viewerMesh.w * a;
        const double height = glm::dot(normal, toViewer); // times both lengths
        const double least = kLeastSine * kLeastSine * glm::dot(normal, normal) * glm::dot(toViewer, toViewer);
        list[kept] = t; // and written over where it turns away: which it is cannot be predicted, so that a branch would take longer
        kept += static_cast<std::size_t>((height >= 0) | (height * height <= least));
    }
    list.resize(kept);
    return list;
}

FrontTriangles::FrontTriangles(const scene::Mesh& mesh, const MeshBuffers& buffers, const dvec4& viewerMesh)
    : viewerMesh_(viewerMesh), triangles_(mesh, buffers, frontTriangles(mesh, viewerMesh)) {}

FrontTriangles::Run FrontTriangles::listed(std::uint32_t first, std::uint32_t count) const {
    const std::vector<std::uint32_t>& list = triangles_.order();
    const auto begin = std::ranges::lower_bound(list, first), end = std::ranges::lower_bound(list, first + count);
    return {static_cast<std::uint32_t>(begin - list.begin()), static_cast<std::uint32_t>(end - begin)};
}

void FrontTriangles::draw(std::uint32_t first, std::uint32_t count) const {
    const Run run = listed(first, count);
    triangles_.draw(run.first, run.count);
}

void FrontTriangles::drawNumbered(std::uint32_t first, std::uint32_t count) const {
    const Run run = listed(first, count);
    triangles_.drawNumbered(run.first, run.count);
}

void FrontTriangles::drawPositions(std::uint32_t first, std::uint32_t count) const {
    const Run run = listed(first, count);
    triangles_.drawPositions(run.first, run.count);
}

} // namespace shadowlab::gl
