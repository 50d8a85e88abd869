// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/picture.h"

#include <algorithm>
#include <array>

#include "techniques/foundation/scene/shading.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::ray_tracing {

namespace {

constexpr int kBlock = trace::SceneTracer::kBlock;

/// Calls work(corner, blockSize) for every block of the picture, on all cores. A thread takes a row of blocks at a time: a
/// tenth of a millisecond's work and more, so that taking it costs nothing, and little enough to leave no core idle.
template <typename Work>
void forEachBlock(ivec2 size, const Work& work) {
    trace::parallelFor(static_cast<std::size_t>((size.y + kBlock - 1) / kBlock), [&](std::size_t row) {
        const int y = static_cast<int>(row) * kBlock;
        for (int x = 0; x < size.x; x += kBlock)
            work(ivec2(x, y), glm::min(ivec2(kBlock), size - ivec2(x, y)));
    });
}

/// Calls work(index, index with rows counted from the bottom) for every pixel, a row of blocks at a time.
template <typename Work>
void forEachPixel(ivec2 size, const Work& work) {
    const auto width = static_cast<std::size_t>(size.x), height = static_cast<std::size_t>(size.y);
    trace::parallelFor((height + kBlock - 1) / kBlock, [&](std::size_t row) {
        for (std::size_t y = row * kBlock; y < std::min(height, (row + 1) * kBlock); ++y)
            for (std::size_t x = 0; x < width; ++x)
                work(y * width + x, (height - 1 - y) * width + x);
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

void Picture::trace(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size,
                    const TraceSettings& settings) {
    size_ = size;
    eyeWorld_ = camera.positionWorld;
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    points_.resize(pixels);
    visibility_.resize(tracer.scene().lights.size());
    for (Grid<trace::Visibility>& ofLight : visibility_)
        ofLight.resize(pixels);

    const trace::EyeRays rays = tracer.eyeRays(camera, size);
    const dvec2 centre(0.5);
    forEachBlock(size, [&](ivec2 corner, ivec2 blockSize) {
        std::array<trace::SurfacePoint, kBlock * kBlock> blockPoints;
        std::array<trace::Visibility, kBlock * kBlock> blockAnswers;
        const auto count = static_cast<std::size_t>(blockSize.x * blockSize.y);
        const std::span points(blockPoints.data(), count);
        const std::span answers(blockAnswers.data(), count);
        const auto forEachRow = [&](const auto& copy) { // copy(place in the block, place in the picture)
            for (int y = 0; y < blockSize.y; ++y)
                copy(y * blockSize.x, static_cast<std::ptrdiff_t>(corner.y + y) * size.x + corner.x);
        };
        if (settings.receivers.empty()) {
            tracer.eyePoints(rays, corner, blockSize, centre, points);
        } else {
            std::array<std::uint32_t, kBlock * kBlock> receivers;
            forEachRow([&](int block, std::ptrdiff_t picture) {
                std::copy_n(settings.receivers.begin() + picture, blockSize.x, receivers.begin() + block);
            });
            tracer.eyePointsOn({receivers.data(), count}, rays, corner, blockSize, centre, points);
        }
        forEachRow([&](int block, std::ptrdiff_t picture) {
            std::transform(points.begin() + block, points.begin() + block + blockSize.x, points_.begin() + picture,
                           [](const trace::SurfacePoint& point) {
                               return KeptPoint{point.primitive, vec2(point.weights), point.eyeOnFront};
                           });
        });
        for (std::size_t light = 0; light < visibility_.size(); ++light) {
            if (settings.start == trace::ShadowStart::exact)
                tracer.visibilities(points, static_cast<int>(light), answers);
            else // each alone: the naive ray starts where no two of a block agree on a plane
                std::ranges::transform(points, answers.begin(), [&](const trace::SurfacePoint& point) {
                    return tracer.visibility(point, static_cast<int>(light), settings.start);
                });
            forEachRow([&](int block, std::ptrdiff_t picture) {
                std::copy_n(answers.begin() + block, blockSize.x, visibility_[light].begin() + picture);
            });
        }
    });
}

void Picture::shadeLightsOff(const trace::SceneTracer& tracer) {
    const scene::Scene& scene = tracer.scene();
    radiance_.resize(points_.size());
    normalWorldFromMesh_.clear();
    for (const scene::Object& object : scene.objects)
        normalWorldFromMesh_.push_back(glm::transpose(glm::inverse(dmat3(object.worldFromObject))));
    forEachPixel(size_, [&](std::size_t i, std::size_t fromBelow) {
        radiance_[fromBelow] = scene.background;
        if (!points_[i]) return;
        const trace::SurfacePoint point = points_[i].surfacePoint();
        const scene::Material& material = materialOf(tracer, point);
        radiance_[fromBelow] = scene.ambient * material.diffuse;
        if (emitsHere(tracer, point)) radiance_[fromBelow] += material.emission;
    });
}

void Picture::shadeLight(const trace::SceneTracer& tracer, int light) {
    const scene::Light& source = tracer.scene().lights[static_cast<std::size_t>(light)];
    const Grid<trace::Visibility>& visibility = visibility_[static_cast<std::size_t>(light)];
    forEachPixel(size_, [&](std::size_t i, std::size_t fromBelow) {
        if (visibility[i] != trace::Visibility::lit) return;
        const trace::SurfacePoint point = points_[i].surfacePoint();
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
        radiance_[fromBelow] += vec3(scene::irradiance(source, positionWorld, normalWorld) *
                                     scene::reflectance(materialOf(tracer, point), normalWorld,
                                                        scene::towardLightWorld(source, positionWorld), toEyeWorld));
    });
}

} // namespace shadowlab::ray_tracing
