// Receiver planes and projecting rays as shapes in the scene, for the camera outside.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "techniques/foundation/base/look.h"
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

/// Rays from the light over the four highest corners of each caster's box, where they end within the frame of the face: two
/// points each, in world space.
std::vector<dvec3> raysOnto(const ChosenReceiver& one, const Projection& projection, const std::vector<Caster>& casters,
                            const gl::EyeMatrices& eye) {
    const dmat4 worldFromView = glm::inverse(eye.viewFromWorld);
    const dvec3 across = one.frameView[1] - one.frameView[0], along = one.frameView[3] - one.frameView[0];
    std::vector<dvec3> rays;
    for (const Caster& caster : casters) {
        if (caster.object == one.receiver.object) continue;
        std::array<dvec4, 8> corners;
        for (int i = 0; i < 8; ++i)
            corners[static_cast<std::size_t>(i)] = eye.viewFromWorld * dvec4(caster.boundsWorld.corner(i), 1.0);
        const auto height = [&](const dvec4& corner) { return glm::dot(projection.planeView, corner); };
        std::ranges::sort(corners, std::ranges::greater{}, height);
        // A corner on the plane has no ray; up to a millionth of the frame is rounding.
        if (height(corners[0]) <= 1e-6 * (glm::length(across) + glm::length(along))) continue;
        for (std::size_t i = 0; i < 4; ++i) {
            const dvec4 shadow = projection.flattenedFromView * corners[i];
            if (height(corners[i]) <= 0 || shadow.w <= 0) continue;
            const dvec3 endView = dvec3(shadow) / shadow.w, offset = endView - one.frameView[0];
            const double u = glm::dot(offset, across) / glm::dot(across, across);
            const double v = glm::dot(offset, along) / glm::dot(along, along);
            if (u < 0 || u > 1 || v < 0 || v > 1) continue;
            const dvec3 fromView = projection.lightView.w > 0 ? dvec3(projection.lightView) : dvec3(corners[i]);
            rays.push_back(transformPoint(worldFromView, fromView));
            rays.push_back(transformPoint(worldFromView, endView));
        }
    }
    return rays;
}

} // namespace

std::vector<SceneShape> Planar::shapes(const scene::Snapshot& snapshot, const View& view, int light) {
    const gl::EyeMatrices eye = gl::eyeMatrices(view.camera, view.size);
    const std::vector<ChosenReceiver> chosen = choose(receivers_.inView(*snapshot, eye, scene::objectBounds(*snapshot)),
                                                      params_.receivers, apartInPicture(view.size))
                                                   .receivers;
    SceneShape outline{"receiver plane", look::kReceiverPlane, SceneShape::Kind::lines, {}};
    SceneShape area{"receiver plane", look::kReceiverPlane, SceneShape::Kind::faces, {}};
    for (const ChosenReceiver& one : chosen)
        addFace(one, *snapshot, outline, area);
    std::vector<SceneShape> shapes = {outline, area};
    if (light < 0 || light >= static_cast<int>(snapshot->lights.size())) return shapes;
    if (view.picked) return shapes; // the probe draws the one ray of the picked pixel

    // Rays onto one plane only, since more would be confusing: the lit plane in view on which most rays end.
    const dvec4 lightWorld = scene::homogeneousPositionWorld(snapshot->light(light));
    SceneShape rays{"rays to the plane", look::kSilhouette, SceneShape::Kind::lines, {}};
    for (const ChosenReceiver& one : chosen) {
        const auto projection = projectOnto(one.planeView, eye.viewFromWorld * lightWorld,
                                            reachOf(eye.viewFromWorld * lightWorld, one.frameView));
        if (!projection || projection->planeView.w <= 0) continue;
        std::vector<dvec3> onto = raysOnto(one, *projection, casters_.all(), eye);
        if (onto.size() > rays.pointsWorld.size()) rays.pointsWorld = std::move(onto);
    }
    shapes.push_back(std::move(rays));
    return shapes;
}

} // namespace shadowlab::planar
