// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/picture.h"

#include <algorithm>

#include "techniques/foundation/scene/shading.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::ray_tracing {

namespace {

// Small enough that the last tiles do not leave cores idle, large enough that neighbouring rays meet the same boxes
// while these are in the cache.
constexpr int kTile = 16;

/// Calls work(x, y, index) for every pixel, tile by tile, on all cores.
template <typename Work>
void forEachPixel(ivec2 size, const Work& work) {
    const int across = (size.x + kTile - 1) / kTile, down = (size.y + kTile - 1) / kTile;
    trace::parallelFor(static_cast<std::size_t>(across) * static_cast<std::size_t>(down), [&](std::size_t tile) {
        const int x0 = static_cast<int>(tile) % across * kTile, y0 = static_cast<int>(tile) / across * kTile;
        for (int y = y0; y < std::min(y0 + kTile, size.y); ++y)
            for (int x = x0; x < std::min(x0 + kTile, size.x); ++x)
                work(x, y,
                     static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x));
    });
}

uvec3 cornersOf(const trace::SceneTracer& tracer, const trace::SurfacePoint& point) {
    const trace::WorldTriangles& world = tracer.world();
    return tracer.objectOf(point)
        .mesh->triangles[point.primitive - world.firstOfObject[world.objects[point.primitive]]];
}

const scene::Material& materialOf(const trace::SceneTracer& tracer, const trace::SurfacePoint& point) {
    const scene::Object& object = tracer.objectOf(point);
    const std::uint32_t triangle =
        point.primitive - tracer.world().firstOfObject[tracer.world().objects[point.primitive]];
    const auto& parts = object.mesh->parts; // in order, covering all triangles
    const auto after =
        std::ranges::upper_bound(parts, triangle, {}, [](const scene::MeshPart& part) { return part.firstTriangle; });
    return tracer.scene().materials[object.partMaterials[static_cast<std::size_t>(after - parts.begin() - 1)]];
}

/// A rect light's surface is dark on its back.
bool emitsHere(const trace::SceneTracer& tracer, const trace::SurfacePoint& point) {
    const int light = tracer.objectOf(point).emitterOfLight;
    const bool rect =
        light >= 0 && tracer.scene().lights[static_cast<std::size_t>(light)].type == scene::LightType::rect;
    return !rect || point.eyeOnFront;
}

} // namespace

void Picture::traceEyeRays(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size) {
    size_ = size;
    eyeWorld_ = camera.positionWorld;
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    points_.resize(pixels);
    answers_.resize(pixels);
    radiance_.resize(pixels);
    normalWorldFromMesh_.clear();
    for (const scene::Object& object : tracer.scene().objects)
        normalWorldFromMesh_.push_back(glm::transpose(glm::inverse(dmat3(object.worldFromObject))));

    const trace::EyeRays rays = tracer.eyeRays(camera, size);
    forEachPixel(size,
                 [&](int x, int y, std::size_t i) { points_[i] = tracer.eyePoint(rays, dvec2(x + 0.5, y + 0.5)); });
}

void Picture::traceShadowRays(const trace::SceneTracer& tracer, int light, trace::ShadowStart start) {
    forEachPixel(size_, [&](int, int, std::size_t i) {
        const trace::SurfacePoint& point = points_[i];
        const trace::Visibility visibility = tracer.visibility(point, light, start);
        answers_[i] = {visibility, visibility >= trace::Visibility::shadowed && tracer.objectOf(point).receivesShadow};
    });
}

void Picture::shadeLightsOff(const trace::SceneTracer& tracer) {
    const scene::Scene& scene = tracer.scene();
    forEachPixel(size_, [&](int, int, std::size_t i) {
        radiance_[i] = scene.background;
        if (!points_[i]) return;
        const scene::Material& material = materialOf(tracer, points_[i]);
        radiance_[i] = scene.ambient * material.diffuse;
        if (emitsHere(tracer, points_[i])) radiance_[i] += material.emission;
    });
}

void Picture::shadeLight(const trace::SceneTracer& tracer, int light) {
    const scene::Light& source = tracer.scene().lights[static_cast<std::size_t>(light)];
    forEachPixel(size_, [&](int, int, std::size_t i) {
        if (answers_[i].visibility != trace::Visibility::lit) return;
        const trace::SurfacePoint& point = points_[i];
        const dvec3 positionWorld = tracer.positionWorld(point);
        const dvec3 toEyeWorld = glm::normalize(eyeWorld_ - positionWorld);
        // The shading normal: interpolated between the corners, turned to the viewer's side.
        const std::vector<vec3>& normalsMesh = tracer.objectOf(point).mesh->normalsMesh;
        const uvec3 corners = cornersOf(tracer, point);
        const dvec3 weights = point.barycentric();
        const dvec3 normalMesh = weights.x * dvec3(normalsMesh[corners.x]) + weights.y * dvec3(normalsMesh[corners.y]) +
                                 weights.z * dvec3(normalsMesh[corners.z]);
        dvec3 normalWorld = glm::normalize(normalWorldFromMesh_[tracer.world().objects[point.primitive]] * normalMesh);
        if (glm::dot(normalWorld, toEyeWorld) < 0) normalWorld = -normalWorld;
        radiance_[i] += vec3(scene::irradiance(source, positionWorld, normalWorld) *
                             scene::reflectance(materialOf(tracer, point), normalWorld,
                                                scene::towardLightWorld(source, positionWorld), toEyeWorld));
    });
}

} // namespace shadowlab::ray_tracing
