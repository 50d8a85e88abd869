// SPDX-License-Identifier: MIT
#include "tests/fuzz/use_scene.h"

#include <array>
#include <cmath>
#include <set>

#include "techniques/foundation/scene/query/casters.h"
#include "techniques/foundation/scene/query/facing.h"
#include "techniques/foundation/scene/query/view/clip_polygon.h"
#include "techniques/foundation/scene/query/view/depth_fit.h"
#include "techniques/foundation/scene/query/view/light_reach.h"
#include "techniques/foundation/scene/query/view/picture_part.h"
#include "techniques/foundation/scene/query/view/visible_receivers.h"
#include "techniques/foundation/trace/scene_tracer.h"
#include "tests/fuzz/target.h"

namespace shadowlab::fuzz {

namespace {

constexpr ivec2 kSize{4, 3}; // pixels: rays through all of them
constexpr double kAspect = 4.0 / 3;

bool isFinite(const dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void useView(const scene::Scene& scene, const std::vector<scene::Bounds>& bounds) {
    require(scene::hasView(scene.camera), "a camera that was taken has a view");
    const scene::Camera tight = scene::withTightNear(scene.camera, scene, bounds, kAspect);
    require(tight.near >= scene.camera.near, "a near plane moves out only");
    const dmat4 clipFromWorld = scene::clipFromView(tight, kAspect) * scene::viewFromWorld(tight);
    const scene::PicturePart whole;
    for (const scene::Bounds& box : bounds) {
        if (!scene::mayTouch(box, clipFromWorld, whole)) continue;
        for (int face = 0; face < 6; ++face) {
            std::vector<dvec4> polygon = scene::boxFaceWorld(box, face);
            for (const dvec4& plane : scene::planesWorld(clipFromWorld, whole))
                polygon = scene::clippedPolygon(polygon, plane);
            require(polygon.size() <= 9, "five planes cut at most five corners off a rectangle");
        }
    }
    static_cast<void>(scene::visibleReceivers(scene, bounds, clipFromWorld, whole, 4));
    static_cast<void>(scene::farDepth(bounds, scene::viewFromWorld(tight), tight.near));
    for (const scene::Light& light : scene.lights) {
        require(scene::usefulCasters(scene, light, bounds).size() <= scene::allCasters(scene).size(),
                "useful casters are casters");
        static_cast<void>(scene::mayLight(scene, light, bounds, tight.positionWorld, clipFromWorld, whole));
    }
}

/// Every structure finds the same hits, to the last bit (trace/structures/engine.h). One for each scene, or little else would be done.
void compareStructures(const trace::SceneTracer& tracer, const trace::EyeRays& rays) {
    using enum trace::Structure;
    constexpr std::array kOthers{objectSpheres, objectBoxes, groups, sphereTree, bvh, grid};
    const trace::WorldTriangles& world = tracer.world();
    const trace::EngineInput input{world.triangles, world.firstOfObject};
    const auto plain = trace::makeEngine(none, input);
    const trace::Structure structure = kOthers[world.triangles.size() % kOthers.size()];
    const auto engine = trace::makeEngine(structure, input);
    for (const auto& building : {plain.get(), engine.get()})
        while (!building->advance(trace::Engine::Deadline::max())) {
        }
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            const trace::Ray ray = rays.through(dvec2(x, y) + 0.5);
            const trace::RayHit one = plain->closest(ray), other = engine->closest(ray);
            require(one.primitive == other.primitive && (!one || one.t == other.t),
                    "structure " + std::to_string(static_cast<int>(structure)) + " hits what none hits");
        }
}

void traceRays(const scene::Snapshot& snapshot) {
    trace::SceneTracer tracer;
    while (!tracer.advance(snapshot, std::chrono::steady_clock::time_point::max())) {
    }
    const trace::EyeRays rays = tracer.eyeRays(snapshot->camera, kSize);
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            const trace::SurfacePoint point = tracer.eyePoint(rays, dvec2(x, y) + 0.5);
            if (!point) continue;
            require(isFinite(tracer.positionCentred(point)), "a hit is somewhere");
            for (int light = 0; light < static_cast<int>(snapshot->lights.size()); ++light)
                static_cast<void>(tracer.visibility(point, light));
        }
    compareStructures(tracer, rays);
}

} // namespace

scene::Limits smallLimits() {
    scene::Limits limits;
    limits.fileBytes = limits.sceneFileBytes = 64 << 10;
    limits.lineBytes = 1 << 10;
    limits.triangles = 120;
    limits.polygonCorners = 40;
    limits.objects = 10;
    limits.lights = 4;
    limits.jsonDepth = 16;
    return limits;
}

void useScene(const scene::Snapshot& snapshot) {
    const std::vector<scene::Bounds> bounds = scene::objectBounds(*snapshot);
    require(bounds.size() == snapshot->objects.size(), "a box for each object");
    std::set<const scene::Mesh*> known;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const scene::Object& object = snapshot->objects[i];
        require(!bounds[i].isEmpty() && isFinite(bounds[i].lowerWorld) && isFinite(bounds[i].upperWorld),
                "an object is somewhere");
        require(object.partMaterials.size() == object.mesh->parts.size(), "a material for each part");
        for (const std::uint32_t material : object.partMaterials)
            require(material < snapshot->materials.size(), "materials that there are");
        if (known.insert(object.mesh.get()).second) useMesh(object.mesh);
    }
    require(std::isfinite(snapshot->exposure) && isFinite(snapshot->ambient) && isFinite(snapshot->background),
            "colours are numbers");
    for (const scene::Light& light : snapshot->lights) {
        require(std::isfinite(light.intensity) && isFinite(light.color), "lights shine with numbers");
        static_cast<void>(scene::facingSigns(*snapshot, light));
    }
    useView(*snapshot, bounds);
    traceRays(snapshot);
    require(scene::withLights(snapshot, snapshot->lights) == snapshot, "the same lights, the same scene");
}

} // namespace shadowlab::fuzz
