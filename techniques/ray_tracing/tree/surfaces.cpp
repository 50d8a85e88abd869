// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/tree/surfaces.h"

#include <algorithm>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/model/surface_color.h"
#include "techniques/foundation/scene/query/shading.h"
#include "techniques/foundation/scene/query/topology/mesh_topology.h"

namespace shadowlab::ray_tracing {

namespace {

/// Six times the volume that a closed mesh encloses; negative where its triangles are turned inward.
double signedVolume(const scene::Mesh& mesh) {
    double sum = 0;
    for (const uvec3& t : mesh.triangles)
        sum += glm::dot(dvec3(mesh.positionsMesh[t.x]),
                        glm::cross(dvec3(mesh.positionsMesh[t.y]), dvec3(mesh.positionsMesh[t.z])));
    return sum;
}

// Parallel to no axis and no diagonal, so that it rarely hits an edge of a built-in shape.
const dvec3 kAwayFromScene = glm::normalize(dvec3(0.3178, 0.9021, 0.2913));

} // namespace

Surfaces::Surfaces(const trace::SceneTracer& tracer) : tracer_(&tracer), normals_(tracer) {
    for (const scene::Object& object : scene().objects) {
        ownColors_.push_back(scene::hasOwnColors(scene(), object));
        bool transparent = false;
        for (const std::uint32_t index : object.partMaterials) {
            const scene::Material& material = scene().materials[index];
            transparent = transparent || material.transparency > 0;
            anySplits_ = anySplits_ || material.reflectivity > 0 || material.transparency > 0;
        }
        for (std::size_t part = 0; part < object.mesh->parts.size(); ++part) // in order, covering all triangles
            materials_.insert(materials_.end(), object.mesh->parts[part].triangleCount, object.partMaterials[part]);
        outsides_.push_back(transparent ? outsideOf(object) : Outside::unknown);
        anySolid_ = anySolid_ || outsides_.back() != Outside::unknown;
    }
}

Surfaces::Outside Surfaces::outsideOf(const scene::Object& object) const {
    const scene::Mesh& mesh = *object.mesh;
    if (!scene::reportMesh(mesh, scene::buildTopology(mesh)).isClosed()) return Outside::unknown;
    const bool outwardInMesh = signedVolume(mesh) > 0;
    return outwardInMesh != scene::isMirrored(object) ? Outside::front : Outside::back;
}

vec3 Surfaces::diffuseOf(const trace::SurfacePoint& point) const {
    if (!hasOwnColors(point)) return materialOf(point).diffuse;
    return scene::diffuseAt(scene(), tracer_->objectOf(point), tracer_->world().triangleInMesh(point.primitive), point.barycentric());
}

bool Surfaces::emitsHere(const trace::SurfacePoint& point) const {
    const scene::Material& material = materialOf(point);
    if (material.emission == vec3(0)) return false; // most: nothing else has to be found out
    return scene::shinesFrom(material, point.eyeOnFront != scene::isMirrored(tracer_->objectOf(point)));
}

// [anchor: shaded-lights-off]
vec3 Surfaces::lightsOff(const trace::SurfacePoint& point) const {
    return scene().ambient * diffuseOf(point) + emitted(point);
}

dvec3 Surfaces::geometricNormalWorld(const trace::SurfacePoint& point) const {
    const trace::Triangle& t = tracer_->bvh().triangles[point.primitive];
    const dvec3 normalWorld = glm::normalize(glm::cross(t.b - t.a, t.c - t.a));
    return point.eyeOnFront ? normalWorld : -normalWorld;
}

// [anchor: shaded-lit]
dvec3 Surfaces::lit(const trace::SurfacePoint& point, int light, const dvec3& positionWorld, const dvec3& normalWorld,
                    const dvec3& toViewerWorld) const {
    const scene::Light& source = scene().light(light);
    const dvec3 irradiance = scene::irradiance(source, positionWorld, normalWorld);
    if (irradiance == dvec3(0.0)) return irradiance; // facing away: no reflectance needed
    return irradiance * scene::reflectance(materialOf(point), dvec3(diffuseOf(point)), normalWorld,
                                           scene::towardLightWorld(source, positionWorld), toViewerWorld);
}

dvec3 Surfaces::litByArea(const trace::SurfacePoint& point, int light, double irradiance, const dvec3& positionWorld,
                          const dvec3& normalWorld, const dvec3& toViewerWorld) const {
    const scene::Light& source = scene().light(light);
    return glm::pi<double>() * irradiance * source.intensity * dvec3(source.color) *
           scene::reflectance(materialOf(point), dvec3(diffuseOf(point)), normalWorld, scene::towardLightWorld(source, positionWorld),
                              toViewerWorld);
}

DielectricStack Surfaces::mediaAround(const dvec3& positionCentred) const {
    if (!anySolid_) return {};
    DielectricStack entered;
    std::vector<Medium> around; // the innermost is left first
    for (trace::SurfacePoint point = tracer_->nextPoint(positionCentred, trace::kNoPrimitive, kAwayFromScene); point;
         point = tracer_->nextPoint(point, kAwayFromScene)) {
        if (!isSolid(point)) continue;
        const Medium medium = mediumOf(point);
        if (!isEntered(point) && !entered.holds(medium)) around.push_back(medium);
        entered.cross(medium, isEntered(point));
    }
    DielectricStack stack;
    for (auto medium = around.rbegin(); medium != around.rend(); ++medium)
        stack.cross(*medium, true);
    return stack;
}

} // namespace shadowlab::ray_tracing
