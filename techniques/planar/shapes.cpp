// Receiver planes and projecting rays as they lie in the scene, for whoever looks on from outside.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/foundation/look.h"
#include "techniques/planar/technique.h"

namespace shadowlab::planar {

namespace {

void addFace(const ChosenReceiver& one, const scene::Scene& scene, SceneShape& outline, SceneShape& area) {
    const scene::Object& object = scene.objects[one.receiver.object];
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    for (const auto& edge : one.receiver.face->outlineMesh)
        for (const dvec3& end : edge)
            outline.pointsWorld.push_back(transformPoint(worldFromMesh, end));
    for (const TriangleRun& run : one.receiver.face->runs)
        for (std::uint32_t t = run.first; t < run.first + run.count; ++t)
            for (int corner = 0; corner < 3; ++corner) {
                const std::uint32_t vertex = object.mesh->triangles[t][corner];
                area.pointsWorld.push_back(transformPoint(worldFromMesh, dvec3(object.mesh->positionsMesh[vertex])));
            }
}

} // namespace

std::vector<SceneShape> Planar::shapes(const scene::Snapshot& snapshot, const View& view, int light) {
    const gl::EyeMatrices eye = gl::eyeMatrices(view.camera, view.size);
    const std::vector<ChosenReceiver> chosen = receivers_.choose(*snapshot, eye, params_.receivers);
    SceneShape outline{"receiver plane", look::kBoundaryEdge, SceneShape::Kind::lines, {}};
    SceneShape area{"receiver plane", look::kBoundaryEdge, SceneShape::Kind::faces, {}};
    for (const ChosenReceiver& one : chosen)
        addFace(one, *snapshot, outline, area);
    std::vector<SceneShape> shapes = {outline, area};
    if (light < 0 || light >= static_cast<int>(snapshot->lights.size())) return shapes;

    // Rays over the corners of the casters' boxes, to the largest plane that the eye sees lit.
    const dvec4 lightWorld = scene::homogeneousPositionWorld(snapshot->lights[static_cast<std::size_t>(light)]);
    SceneShape rays{"ray from the light to the plane", look::kSilhouette, SceneShape::Kind::lines, {}};
    for (const ChosenReceiver& one : chosen) {
        const auto projection = projectOnto(one.planeView, eye.viewFromWorld * lightWorld);
        if (!projection || projection->planeView.w <= 0) continue;
        const dmat4 worldFromView = glm::inverse(eye.viewFromWorld);
        const std::vector<scene::Bounds> bounds = scene::objectBounds(*snapshot);
        scene::Bounds all;
        for (const scene::Bounds& box : bounds)
            all.include(box);
        const double longest = all.isEmpty() ? 0 : 2 * glm::length(all.upperWorld - all.lowerWorld);
        for (const Caster& caster : casters_.of(light))
            for (int i = 0; i < 8; ++i) {
                const dvec3 cornerWorld = bounds[caster.object].corner(i);
                const dvec4 corner = eye.viewFromWorld * dvec4(cornerWorld, 1.0);
                const dvec4 shadow = projection->flattenedFromView * corner;
                // On the plane there is no ray to be seen, beyond the light none goes on to the plane.
                const double shortest = 1e-6 * longest; // what is nearer lies on the plane
                if (glm::dot(projection->planeView, corner) <= shortest || shadow.w <= 0) continue;
                const dvec3 endWorld = transformPoint(worldFromView, dvec3(shadow) / shadow.w);
                const dvec3 fromWorld = lightWorld.w > 0 ? dvec3(lightWorld) : cornerWorld;
                if (glm::length(endWorld - cornerWorld) > longest) continue; // hardly below the light's height
                rays.pointsWorld.insert(rays.pointsWorld.end(), {fromWorld, endWorld});
            }
        break;
    }
    shapes.push_back(std::move(rays));
    return shapes;
}

} // namespace shadowlab::planar
