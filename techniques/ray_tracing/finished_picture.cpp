// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/finished_picture.h"

#include <algorithm>

#include "techniques/foundation/trace/parallel.h"
#include "techniques/ray_tracing/lanes/pixel_lanes.h"

namespace shadowlab::ray_tracing {

namespace {

void put(Lane (&lanes)[3], std::size_t i, const vec3& value) {
    lanes[0][i] = value.r;
    lanes[1][i] = value.g;
    lanes[2][i] = value.b;
}

/// Fills the lanes with pixels side by side.
class Gathering {
public:
    Gathering(const Surfaces& surfaces, const Picture& traced)
        : surfaces_(surfaces), hits_(traced.points()), triangles_(surfaces.tracer().bvh().triangles),
          eyeCentred_(traced.camera().positionWorld - surfaces.tracer().world().originWorld) {}

    void operator()(std::size_t first, std::size_t count, PixelLanes& pixels) const {
        pixels.count = count;
        pixels.anySpecular = false;
        for (std::size_t i = 0; i < count;) {
            const trace::SurfacePoint& hit = hits_[first + i];
            std::size_t end = i + 1; // of the run of pixels that see this triangle
            while (end < count && hits_[first + end].primitive == hit.primitive && hits_[first + end].eyeOnFront == hit.eyeOnFront)
                ++end;
            if (hit)
                addRun(&hits_[first], i, end, pixels);
            else
                addBackground(i, end, pixels);
            i = end;
        }
    }

private:
    /// What is the same in all of a triangle is found once. Corners are taken relative to the eye in double, so that nothing is lost
    /// far from the origin.
    void addRun(const trace::SurfacePoint* hits, std::size_t begin, std::size_t end, PixelLanes& pixels) const {
        const trace::SurfacePoint point = hits[begin];
        const trace::Triangle& triangle = triangles_[point.primitive];
        const vec3 c(triangle.c - eyeCentred_), ca(triangle.a - triangle.c), cb(triangle.b - triangle.c);
        const trace::ShadingNormals& normals = surfaces_.normals();
        const bool isKnown = normals.areOnFront(point);
        const float side = isKnown && !normals.isFrontSeen(point) ? -1.0f : 1.0f;
        const auto [normalA, normalB, normalAtC] = normals.ofCornersWorld(point);
        const vec3 normalC = side * normalAtC, normalCA = side * normalA - normalC, normalCB = side * normalB - normalC;
        const scene::Material& material = surfaces_.materialOf(point);
        const vec3 lightsOff = surfaces_.lightsOff(point);
        const bool ownColors = surfaces_.hasOwnColors(point);
        pixels.anySpecular = pixels.anySpecular || material.specular != vec3(0);
        for (std::size_t i = begin; i < end; ++i) {
            const vec2 weights = hits[i].weights;
            put(pixels.positionEye, i, c + weights.x * ca + weights.y * cb);
            put(pixels.normalWorld, i, normalC + weights.x * normalCA + weights.y * normalCB);
            pixels.mayTurn[i] = isKnown ? 0.0f : 1.0f;
            put(pixels.diffuse, i, ownColors ? surfaces_.diffuseOf(hits[i]) : material.diffuse);
            put(pixels.specular, i, material.specular);
            pixels.shininess[i] = material.shininess;
            put(pixels.radiance, i, ownColors ? surfaces_.lightsOff(hits[i]) : lightsOff);
        }
    }
    void addBackground(std::size_t begin, std::size_t end, PixelLanes& pixels) const {
        for (std::size_t i = begin; i < end; ++i)
            put(pixels.radiance, i, surfaces_.scene().background); // no light reaches it, and so nothing else is asked of it
    }

    const Surfaces& surfaces_;
    const Grid<trace::SurfacePoint>& hits_;
    const std::vector<trace::Triangle>& triangles_;
    dvec3 eyeCentred_;
};

/// Marks the pixels that a light reaches; false: there are none.
bool markLit(const Grid<trace::Visibility>& visibility, std::size_t first, PixelLanes& pixels) {
    bool any = false;
    for (std::size_t i = 0; i < pixels.count; ++i) {
        const bool isLit = visibility[first + i] == trace::Visibility::lit;
        pixels.isLit[i] = isLit ? 1.0f : 0.0f;
        any = any || isLit;
    }
    return any;
}

} // namespace

void FinishedPicture::encode(const Grid<vec3>& radiance, float exposure) {
    const LaneKernels& kernels = bestLaneKernels();
    colors_.resize(radiance.size());
    constexpr std::size_t kRun = 8192; // pixels for a thread at a time
    trace::parallelFor((radiance.size() + kRun - 1) / kRun, [&](std::size_t run) {
        PixelLanes pixels{};
        const std::size_t end = std::min(radiance.size(), (run + 1) * kRun);
        for (std::size_t first = run * kRun; first < end; first += kLanes) {
            pixels.count = std::min(kLanes, end - first);
            for (std::size_t i = 0; i < pixels.count; ++i)
                put(pixels.radiance, i, radiance[first + i]);
            ray_tracing::encode(kernels, pixels, exposure, std::span(colors_).subspan(first));
        }
    });
}

void FinishedPicture::shade(const Surfaces& surfaces, const Picture& traced) {
    const LaneKernels& kernels = bestLaneKernels();
    std::vector<LaneLight> lights;
    for (const scene::Light& light : surfaces.scene().lights)
        lights.push_back(laneLight(light, traced.camera().positionWorld));
    const Gathering gather(surfaces, traced);
    const auto width = static_cast<std::size_t>(traced.size().x), height = static_cast<std::size_t>(traced.size().y);
    colors_.resize(width * height);
    trace::parallelFor(height, [&](std::size_t y) {
        PixelLanes pixels{};
        for (std::size_t x = 0; x < width; x += kLanes) {
            const std::size_t first = y * width + x;
            gather(first, std::min(kLanes, width - x), pixels);
            bool isTurned = false;
            for (std::size_t light = 0; light < lights.size(); ++light) {
                if (!markLit(traced.visibility(static_cast<int>(light)), first, pixels)) continue;
                if (!isTurned) kernels.turnToEye(pixels);
                isTurned = true;
                addLight(kernels, pixels, lights[light]);
            }
            ray_tracing::encode(kernels, pixels, surfaces.scene().exposure, std::span(colors_).subspan((height - 1 - y) * width + x));
        }
    });
}

} // namespace shadowlab::ray_tracing
