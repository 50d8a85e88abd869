// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/probe/shapes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/scene/query/facing.h"
#include "techniques/probe.h"
#include "techniques/probed/volume_probe.h"
#include "techniques/shadow_volume/count/volume.h"

namespace shadowlab::shadow_volume {

namespace {

// Shapes that reach infinity are cut off this far beyond the scene, as a share of its size.
constexpr double kBeyondScene = 0.02;
// Lines from the silhouette away from the light, where a volume is drawn without faces: enough to see where it is.
constexpr std::size_t kMostOutlines = 24;

scene::Bounds somewhatLarger(scene::Bounds bounds) {
    const double more = kBeyondScene * glm::length(bounds.upperWorld - bounds.lowerWorld);
    bounds.lowerWorld -= more;
    bounds.upperWorld += more;
    return bounds;
}

/// The point in which a ray from inside the box leaves it.
dvec3 leaving(const scene::Bounds& box, const dvec3& pointWorld, const dvec3& directionWorld) {
    double stretch = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double wall = directionWorld[axis] > 0 ? box.upperWorld[axis] : box.lowerWorld[axis];
        if (directionWorld[axis] != 0) stretch = std::min(stretch, (wall - pointWorld[axis]) / directionWorld[axis]);
    }
    return std::isfinite(stretch) ? pointWorld + stretch * directionWorld : pointWorld;
}

} // namespace

Volume buildShown(const scene::Object& object, const scene::Light& light, const CasterVolume& caster,
                  const ShownVolume& shown, std::vector<SilhouetteEdge>& silhouette) {
    std::vector<std::int8_t> facing = scene::facingSigns(object, light);
    Volume volume;
    if (shown.construction == Construction::lecture) {
        buildLectureVolume(*object.mesh, caster.mesh->edges, facing, silhouette, volume);
        return volume;
    }
    if (caster.report.isClosed()) std::ranges::replace(facing, std::int8_t{-1}, std::int8_t{0});
    buildVolume(*object.mesh, caster.mesh->edges, facing, silhouette, volume);
    return volume;
}

std::vector<SceneShape> volumeShapes(const scene::Scene& scene, const View& view, int light,
                                     std::span<const CasterVolume* const> casters, bool withCaps,
                                     const ShownVolume& shown) {
    std::vector<SceneShape> allSides, allTops, allBottoms, allEdges;
    const scene::Light& source = scene.light(light);
    const dvec4 lightWorld = scene::homogeneousPositionWorld(source);
    scene::Bounds all;
    for (const scene::Bounds& box : scene::objectBounds(scene))
        all.include(box);
    const scene::Bounds end = somewhatLarger(all);

    for (const CasterVolume* caster : casters) {
        SceneShape edges{"silhouette", look::kSilhouette, SceneShape::Kind::lines, {}, caster->object};
        SceneShape sides{"sides", look::kVolumeSide, SceneShape::Kind::faces, {}, caster->object};
        SceneShape top{"top cap", look::kTopCap, SceneShape::Kind::faces, {}, caster->object};
        SceneShape bottom{"bottom cap", look::kBottomCap, SceneShape::Kind::faces, {}, caster->object};
        const scene::Object& object = scene.objects[caster->object];
        const scene::Mesh& mesh = *object.mesh;
        std::vector<SilhouetteEdge> silhouette;
        const Volume volume = buildShown(object, source, *caster, shown, silhouette);
        // Vertices twice, as they are and at the end of the scene: the numbering of Volume.
        const dmat4 worldFromMesh = scene::worldFromMesh(object);
        const std::size_t n = mesh.positionsMesh.size();
        std::vector<dvec3> pointsWorld(2 * n);
        for (std::size_t v = 0; v < n; ++v) {
            pointsWorld[v] = transformPoint(worldFromMesh, dvec3(mesh.positionsMesh[v]));
            pointsWorld[n + v] =
                shown.distance
                    ? dvec3(pushedWorld(pointsWorld[v], source, {.planeWorld = {}, .distance = shown.distance}))
                    : leaving(end, pointsWorld[v], pointsWorld[v] * lightWorld.w - dvec3(lightWorld));
        }
        const auto add = [&](SceneShape& shape, const std::vector<std::uint32_t>& indices) {
            for (const std::uint32_t index : indices)
                shape.pointsWorld.push_back(pointsWorld[index]);
        };
        for (const SilhouetteEdge& edge : silhouette)
            add(edges, {edge.a, edge.b});
        if (view.picked) { // the probe shows the faces that its line crosses: all of them would hide these
            sides.kind = SceneShape::Kind::lines;
            const std::size_t step = std::max<std::size_t>(1, silhouette.size() / kMostOutlines);
            for (std::size_t i = 0; i < silhouette.size(); i += step)
                add(sides, {silhouette[i].a, static_cast<std::uint32_t>(n + silhouette[i].a)});
            allSides.push_back(std::move(sides));
            allEdges.push_back(std::move(edges));
            continue;
        }
        add(sides, volume.sides);
        add(top, volume.topCap);
        add(top, volume.topCapReversed);
        add(bottom, volume.bottomCap);
        allSides.push_back(std::move(sides));
        allTops.push_back(std::move(top));
        allBottoms.push_back(std::move(bottom));
        allEdges.push_back(std::move(edges));
    }
    if (!withCaps) {
        allTops.clear();
        allBottoms.clear();
    }
    // In the order in which they are drawn: the silhouettes last, over all faces.
    std::vector<SceneShape> shapes;
    for (std::vector<SceneShape>* part : {&allSides, &allTops, &allBottoms, &allEdges})
        std::ranges::move(*part, std::back_inserter(shapes));
    shapes.push_back(nearClipPyramid(scene, view, light));
    return shapes;
}

std::vector<SceneShape> crossedShapes(const scene::Scene& scene, const VolumeProbe& probe) {
    SceneShape enters{"+1: the ray enters", look::diverging()[6], SceneShape::Kind::faces, {}};
    SceneShape leaves{"-1: the ray leaves", look::diverging()[2], SceneShape::Kind::faces, {}};
    SceneShape entersRim{enters.label, enters.colorLinear, SceneShape::Kind::lines, {}};
    SceneShape leavesRim{leaves.label, leaves.colorLinear, SceneShape::Kind::lines, {}};
    scene::Bounds all;
    for (const scene::Bounds& box : scene::objectBounds(scene))
        all.include(box);
    all.include(scene.camera.positionWorld);
    const scene::Bounds end = somewhatLarger(all);
    for (const VolumeProbe::Crossing& crossing : probe.crossings) {
        // Beyond the point, or before it: what the technique's way of counting leaves aside would contradict its count.
        if (crossing.counted == 0 && crossing.uncounted.empty()) continue;
        dvec3 finite(0.0);
        bool any = false;
        for (const dvec4& corner : crossing.cornersWorld)
            if (corner.w != 0) {
                finite = dvec3(corner);
                any = true;
            }
        if (!any) continue; // all of it is at infinity
        std::vector<dvec3> corners;
        for (const dvec4& corner : crossing.cornersWorld)
            corners.push_back(corner.w != 0 ? dvec3(corner) : leaving(end, finite, dvec3(corner)));
        SceneShape &face = crossing.sign > 0 ? enters : leaves, &rim = crossing.sign > 0 ? entersRim : leavesRim;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            face.pointsWorld.push_back(corners[i]);
            rim.pointsWorld.insert(rim.pointsWorld.end(), {corners[i], corners[(i + 1) % corners.size()]});
        }
    }
    return {std::move(enters), std::move(leaves), std::move(entersRim), std::move(leavesRim)};
}

void addCountMethods(std::vector<SceneShape>& shapes, std::span<const CasterVolume* const> casters,
                     const std::function<CountMethod(const CasterVolume&)>& countMethodOf) {
    SceneShape passing{"counted by depth pass", look::kDepthPass, SceneShape::Kind::lines, {}};
    SceneShape failing{"counted by depth fail", look::kDepthFail, SceneShape::Kind::lines, {}};
    for (const CasterVolume* caster : casters) {
        SceneShape& shape = countMethodOf(*caster) == CountMethod::zPass ? passing : failing;
        for (int corner = 0; corner < 8; ++corner)
            for (const int axis : {1, 2, 4})
                if (!(corner & axis))
                    shape.pointsWorld.insert(shape.pointsWorld.end(),
                                             {caster->bounds.corner(corner), caster->bounds.corner(corner | axis)});
    }
    for (SceneShape* shape : {&passing, &failing})
        if (!shape->pointsWorld.empty()) shapes.push_back(std::move(*shape));
}

SceneShape nearClipPyramid(const scene::Scene& scene, const View& view, int light) {
    const scene::Camera& camera = view.camera;
    const dmat4 worldFromView = glm::inverse(scene::viewFromWorld(camera));
    const double halfHeight = camera.near * std::tan(camera.fovYDegrees * glm::pi<double>() / 360.0);
    const double halfWidth = halfHeight * view.size.x / view.size.y;
    scene::Bounds all;
    for (const scene::Bounds& box : scene::objectBounds(scene))
        all.include(box);
    all.include(camera.positionWorld);
    const scene::Bounds end = somewhatLarger(all);
    const dvec4 lightWorld = scene::homogeneousPositionWorld(scene.light(light));

    SceneShape pyramid{"near-clip pyramid", look::kNearClipPyramid, SceneShape::Kind::lines, {}};
    pyramid.onRequest = true;
    constexpr int kAround[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const auto corner = [&](int i) {
        return transformPoint(worldFromView,
                              dvec3(kAround[i % 4][0] * halfWidth, kAround[i % 4][1] * halfHeight, -camera.near));
    };
    for (int i = 0; i < 4; ++i) {
        const dvec3 apexWorld = lightWorld.w == 0 ? leaving(end, corner(i), dvec3(lightWorld)) : dvec3(lightWorld);
        pyramid.pointsWorld.insert(pyramid.pointsWorld.end(), {corner(i), corner(i + 1), corner(i), apexWorld});
    }
    return pyramid;
}

VolumeProbe::Caster describedCaster(const scene::Scene& scene, const scene::Light& light, const CasterVolume& caster,
                                    const ShownVolume& shown, const VolumeEnd& end) {
    const scene::Object& object = scene.objects[caster.object];
    VolumeProbe::Caster described;
    described.object = caster.object;
    described.facing = scene::facingSigns(object, light);
    std::vector<SilhouetteEdge> silhouette;
    Volume volume = buildShown(object, light, caster, shown, silhouette);
    for (const SilhouetteEdge& edge : silhouette)
        described.outline.push_back({edge.a, edge.b, edge.triangles});
    described.topCap = std::move(volume.topCap);
    described.topCap.insert(described.topCap.end(), volume.topCapReversed.begin(), volume.topCapReversed.end());
    described.sides = std::move(volume.sides);
    described.bottomCap = std::move(volume.bottomCap);
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    described.extrudedWorld.reserve(object.mesh->positionsMesh.size());
    for (const vec3& position : object.mesh->positionsMesh)
        described.extrudedWorld.push_back(pushedWorld(transformPoint(worldFromMesh, dvec3(position)), light, end));
    described.distance = end.planeWorld ? std::nullopt : end.distance;
    described.endWorld = end.planeWorld;
    return described;
}

std::string casterText(const scene::Scene& scene, const VolumeProbe::Caster& caster) {
    const auto towardLight = std::ranges::count_if(caster.facing, [](std::int8_t sign) { return sign > 0; });
    return scene.objects[caster.object].name + ": " + std::to_string(towardLight) + " of " +
           std::to_string(caster.facing.size()) + " triangles face the light, " +
           std::to_string(caster.outline.size()) + " outline edges, extruded " +
           (caster.endWorld   ? "to a plane beyond all that receives its shadow"
            : caster.distance ? "by " + probeText(*caster.distance) + " m"
                              : "to infinity");
}

} // namespace shadowlab::shadow_volume
