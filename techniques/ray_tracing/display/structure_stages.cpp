// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/display/stages.h"

#include <algorithm>

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/ray_tracing/described.h"
#include "techniques/ray_tracing/display/line_picture.h"
#include "techniques/ray_tracing/display/upload.h"
#include "techniques/ray_tracing/structures/structure_shapes.h"

namespace shadowlab::ray_tracing {

void publishTests(Frame& frame, const trace::SceneTracer& tracer, const StructureCache& structures) {
    const ivec2 size = frame.view().size;
    const trace::Engine& engine = structures.engine();
    const trace::EyeRays rays = tracer.eyeRays(frame.view().camera, size);
    const auto width = static_cast<std::size_t>(size.x), height = static_cast<std::size_t>(size.y);
    Grid<std::uint64_t> tests(width * height, 0);
    if (engine.counts())
        trace::parallelFor(height, [&](std::size_t y) {
            for (std::size_t x = 0; x < width; ++x)
                tests[y * width + x] = tracer.testsOf(engine, rays, dvec2(x, y) + 0.5).all();
        });
    // One pixel in a hundred may lie beyond the scale: a few rays along edges need far more tests than all others.
    Grid<std::uint64_t> sorted = tests;
    std::ranges::sort(sorted);
    const Display display{.minimum = 0,
                          .maximum =
                              std::max(1.0, static_cast<double>(sorted[sorted.size() - 1 - sorted.size() / 100])),
                          .unit = engine.counts() ? "tests" : "tests, which Embree does not tell",
                          .key = {}};
    gl::Texture2D texture(GL_RG32F, size, kTestsStage.id);
    upload(texture, tests, size,
           [&](std::uint64_t count) { return vec2(static_cast<float>(count), engine.counts() ? 1.0f : 0.0f); });
    frame.publish(kTestsStage.id, kNoLight, std::move(texture), display);
}

void publishStructure(Frame& frame, const trace::SceneTracer& tracer, const StructureCache& structures,
                      const Picture& picture) {
    const scene::Camera& camera = frame.view().camera;
    const ivec2 size = picture.size();
    const auto width = static_cast<std::size_t>(size.x), height = static_cast<std::size_t>(size.y);
    const dvec3 axisWorld = glm::normalize(camera.targetWorld - camera.positionWorld);
    std::vector<vec3> ground(width * height);
    std::vector<double> depths(width * height, std::numeric_limits<double>::infinity());
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t i = y * width + x;
            const vec3 radiance = picture.radianceFromBelow()[(height - 1 - y) * width + x];
            const float luminance = glm::dot(radiance, vec3(0.2126f, 0.7152f, 0.0722f)); // Rec. 709
            // Dimmed a little, so that lines stand out from white.
            ground[i] = vec3(0.6f * std::min(1.0f, frame.scene().exposure * luminance));
            if (picture.points()[i])
                depths[i] = glm::dot(tracer.positionWorld(picture.points()[i]) - camera.positionWorld,
                                     axisWorld);
        }

    const std::vector<SceneShape> shapes =
        structureShapes(structures.engine(), structures.chosen(), tracer.world().originWorld, camera.positionWorld);
    LinePicture lines(std::move(ground), std::move(depths), camera, size);
    Display display{.unit = "", .key = {}};
    // The innermost volumes first: the outer ones, which are few, are drawn over them.
    for (auto shape = shapes.rbegin(); shape != shapes.rend(); ++shape) {
        const bool isOuter = shape + 1 == shapes.rend() && structures.chosen() != trace::Structure::grid;
        const int radius = isOuter ? look::lineRadius(size.y) : look::lineRadius(size.y) - 1;
        for (std::size_t i = 0; i + 1 < shape->pointsWorld.size(); i += 2)
            lines.draw(shape->pointsWorld[i], shape->pointsWorld[i + 1], shape->colorLinear, radius);
    }
    for (const SceneShape& shape : shapes)
        display.key.push_back({shape.colorLinear, shape.label});
    if (shapes.empty()) display.key.push_back({look::kNotAsked, "nothing to be shown"});
    gl::Texture2D texture(GL_RGBA16F, size, kStructureStage.id);
    upload(texture, lines.colors(), size, [](const vec3& color) { return vec4(color, 1.0f); });
    frame.publish(kStructureStage.id, kNoLight, std::move(texture), display);
}

} // namespace shadowlab::ray_tracing
