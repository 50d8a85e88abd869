// Ray tracing, in its simplest form: from the eye through every pixel, and from what is seen there to every light.
//
// Appel, "Some Techniques for Shading Machine Renderings of Solids", 1968, sent the first rays from a point on paper
// through the holes of a plotter; Whitted, "An Improved Illumination Model for Shaded Display", 1980, made a recursion
// of it. Here the recursion ends at once: no mirrors, no glass. What is asked is the definition of a shadow itself, "is
// anything between this point and the light?", so nothing is approximated: no map with texels, no count in a stencil.
// Left out on purpose: soft shadows (a light is a point).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/id_buffer.h"
#include "techniques/foundation/look.h"
#include "techniques/frame.h"
#include "techniques/ray_tracing/picture.h"
#include "techniques/ray_tracing/ray_shapes.h"
#include "techniques/ray_tracing/structure_params.h"
#include "techniques/ray_tracing/structure_shapes.h"
#include "techniques/ray_tracing/structure_stages.h"
#include "techniques/ray_tracing/upload.h"

namespace shadowlab::ray_tracing {

namespace {

const PassInfo kPasses[] = {
    {"id-buffer", "Draw the number of the triangle that each pixel shows",
     "The rasteriser finds what eye rays would find; each ray only checks that it hits the triangle it is told. Only "
     "with "
     "receivers = id-buffer.",
     "depth test LESS, depth write on; the numbers are read back", false, "primary-hits"},
    {"visibility", "Send a ray from the eye through every pixel, and from where it ends a ray to every light",
     "The nearest triangle that the eye ray hits is what the pixel shows. If the ray to a light hits anything on its "
     "way, "
     "whatever that is and however far, the point is in shadow: the first hit is enough.",
     "none: the processor traces, on all cores, 64 neighbouring rays at a time", false, "shadow-rays"},
    {"lights-off", "Show what is seen with all lights off", "Emission and ambient light are counted here, once.",
     "none: the processor shades; the picture is uploaded", false},
    {"light", "Add the light where its ray has arrived",
     "The same shading as in every other technique; only the question who is in shadow is answered in another way.",
     "none: the processor shades; the picture is uploaded", true},
};

const StageInfo kStages[] = {
    {"primary-hits", "Where eye rays end: distance from the eye", StageKind::scalar, false},
    {"lights-off", "Scene with lights off", StageKind::radiance, false},
    {"shadow-rays", "What came of the shadow rays", StageKind::swatches, true},
    {"visibility", "Visibility of the light", StageKind::visibility, true},
    kTestsStage,
    kStructureStage,
};

constexpr trace::Visibility kLit = trace::Visibility::lit;

struct RayTracedParams {
    bool excludeSource = true;
    enum class Receivers { traced, idBuffer } receivers = Receivers::traced;
};

class RayTraced final : public Technique {
public:
    params::ParamList params() override {
        params::ParamList list = {
            params::boolean("exclude-source", params_.excludeSource,
                            "A shadow ray leaves out the triangle it starts on; false: it starts from a point rounded "
                            "to float, and meets that triangle every now and then (teaching)."),
            params::choice(
                "receivers", params_.receivers, {"traced", "id-buffer"},
                "How the triangle of a pixel is found: by its eye ray; or drawn by the rasteriser, and traced "
                "only where the ray does not hit that triangle. At ties (docs/conventions.md) the two may "
                "differ."),
        };
        std::ranges::move(describe(structureParams_), std::back_inserter(list));
        return list;
    }
    Progress prepare(const scene::Snapshot& snapshot, Deadline deadline) override {
        tracer_.askInstead(nullptr);
        if (!tracer_.advance(snapshot, deadline)) return {tracer_.done(), false};
        const Progress progress = structures_.prepare(tracer_.geometry(), structureParams_.structure, deadline);
        if (progress.converged && structures_.chosen() != trace::Structure::bvh)
            tracer_.askInstead(&structures_.engine());
        return progress;
    }

    Progress render(Frame& frame) override {
        // Tracing draws nothing: who stops after it sees an empty picture.
        gl::setBaselineState();
        frame.target().framebuffer.bind();
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        TraceSettings settings;
        settings.start = params_.excludeSource ? trace::ShadowStart::exact : trace::ShadowStart::naive;
        std::vector<std::uint32_t> receivers;
        if (params_.receivers == RayTracedParams::Receivers::idBuffer) {
            frame.pass(passInfo(kPasses, "id-buffer"), [&] {
                idBuffer_.draw(frame.scene(), frame.buffers(), frame.eye(), frame.view().size);
                receivers = idBuffer_.read();
            });
            settings.receivers = receivers;
        }
        frame.pass(passInfo(kPasses, "visibility"),
                   [&] { picture_.trace(tracer_, frame.view().camera, frame.view().size, settings); });
        countRays(frame);
        if (frame.wants("primary-hits")) publishDistances(frame);

        frame.pass(passInfo(kPasses, "lights-off"), [&] {
            picture_.shadeLightsOff(tracer_);
            show(frame);
        });
        if (frame.wants("lights-off")) frame.publishTarget("lights-off");

        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light) {
            if (frame.wants("shadow-rays", light)) publishShadowRays(frame, light);
            if (frame.wants("visibility", light)) publishVisibility(frame, light);
            frame.pass(
                passInfo(kPasses, "light"),
                [&] {
                    picture_.shadeLight(tracer_, light);
                    show(frame);
                },
                light);
        }
        if (frame.wants(kTestsStage.id)) publishTests(frame, tracer_, structures_);
        if (frame.wants(kStructureStage.id)) publishStructure(frame, tracer_, structures_, picture_);
        return {};
    }

    Probe probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) override;
    std::vector<SceneShape> shapes(const scene::Snapshot&, const View& view, int light) override {
        std::vector<SceneShape> shapes = rayShapes(tracer_, view, light);
        // Of the tree, which is there even if nobody looks at it, the rays alone are shown.
        if (structures_.chosen() != trace::Structure::bvh)
            std::ranges::move(
                structureShapes(structures_.engine(), structures_.chosen(), tracer_.world().originWorld, std::nullopt),
                std::back_inserter(shapes));
        return shapes;
    }
    std::string remark(const scene::MeshReport& report, const scene::Mesh&) const override {
        return std::string("any triangles will do, closed or not, in any winding: rays meet them from both sides") +
               (report.hasHoles ? ", and pass through the holes that an alpha map cuts" : "");
    }

private:
    void show(const Frame& frame) const {
        uploadFromBelow(frame.target().color, picture_.radianceFromBelow(), picture_.size());
    }

    void countRays(Frame& frame) const {
        using enum trace::Visibility;
        const Grid<KeptPoint>& points = picture_.points();
        const auto hits = std::ranges::count_if(points, [](const KeptPoint& point) { return bool(point); });
        frame.count("eye-rays", static_cast<double>(hits), static_cast<double>(points.size()), "hits");
        const bool allReceive = std::ranges::all_of(frame.scene().objects, &scene::Object::receivesShadow);
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light) {
            std::size_t asked = 0, blocked = 0;
            for (std::size_t i = 0; i < points.size(); ++i) {
                const trace::Visibility visibility = picture_.visibility(light)[i];
                asked +=
                    visibility >= shadowed && (allReceive || tracer_.objectOf(points[i].surfacePoint()).receivesShadow)
                        ? 1
                        : 0;
                blocked += visibility == shadowed ? 1 : 0;
            }
            frame.count("shadow-rays", static_cast<double>(blocked), static_cast<double>(asked), "blocked");
        }
    }

    void publishDistances(Frame& frame) const {
        Display display{.minimum = 0, .maximum = 1, .unit = "m from the eye", .key = {}};
        // One pixel in fifty may lie beyond each end of the scale, or a horizon would make everything near one colour.
        const trace::EyeRays rays = tracer_.eyeRays(frame.view().camera, frame.view().size);
        std::vector<double> distances;
        for (const KeptPoint& point : picture_.points())
            if (point) distances.push_back(tracer_.distance(rays, point.surfacePoint()));
        if (!distances.empty()) {
            std::ranges::sort(distances);
            display.minimum = distances[distances.size() / 50];
            display.maximum = std::max(distances[distances.size() - 1 - distances.size() / 50],
                                       display.minimum + 1e-3 * distances.back());
        }
        gl::Texture2D texture(GL_RG32F, picture_.size(), "primary-hits");
        upload(texture, picture_.points(), picture_.size(), [&](const KeptPoint& point) {
            return point ? vec2(static_cast<float>(tracer_.distance(rays, point.surfacePoint())), 1.0f) : vec2(0.0f);
        });
        frame.publish("primary-hits", kNoLight, std::move(texture), display);
    }

    void publishShadowRays(Frame& frame, int light) const {
        const Display display{.unit = "",
                              .key = {{look::kEqualDepth, "the ray arrives: lit"},
                                      {look::kOccluded, "something is in its way: in shadow"},
                                      {look::kNotAsked, "faces away or outside the light: no ray sent"}}};
        gl::Texture2D texture(GL_RGBA16F, picture_.size(), "shadow-rays");
        const vec3 background = frame.scene().background;
        upload(texture, picture_.visibility(light), picture_.size(), [&](trace::Visibility visibility) {
            using enum trace::Visibility;
            switch (visibility) {
            case noSurface: return vec4(background, 1.0f);
            case turnedAway: return vec4(look::kNotAsked, 1.0f);
            case shadowed: return vec4(look::kOccluded, 1.0f);
            case lit: return vec4(look::kEqualDepth, 1.0f);
            }
            return vec4(0.0f);
        });
        frame.publish("shadow-rays", light, std::move(texture), display);
    }

    void publishVisibility(Frame& frame, int light) const {
        gl::Texture2D texture(GL_RG32F, picture_.size(), "visibility");
        upload(texture, picture_.visibility(light), picture_.size(), [](trace::Visibility visibility) {
            return vec2(visibility == kLit ? 1.0f : 0.0f, visibility == trace::Visibility::noSurface ? 0.0f : 1.0f);
        });
        frame.publish("visibility", light, std::move(texture));
    }

    RayTracedParams params_;
    StructureParams structureParams_;
    KeptStructures structures_;
    trace::SceneTracer tracer_;
    Picture picture_;
    gl::IdBuffer idBuffer_;
};

/// The rays of one pixel, as a tree: the eye ray, and below it a shadow ray for every light.
Probe RayTraced::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe = Technique::probe(snapshot, view, pixel, light);
    trace::SceneTracer tracer;
    tracer.advance(snapshot, Deadline::max());
    const trace::EyeRays rays = tracer.eyeRays(view.camera, view.size);
    const trace::SurfacePoint point = tracer.eyePoint(rays, dvec2(pixel) + 0.5);
    if (!point) return probe;
    const std::string object = tracer.objectOf(point).name;
    // What is there already is used; the command line has nothing yet.
    KeptStructures own;
    const bool isThere = structures_.isReady(tracer.geometry(), structureParams_.structure);
    if (!isThere) own.prepare(tracer.geometry(), structureParams_.structure, Deadline::max());
    const trace::Engine& engine = (isThere ? structures_ : own).engine();
    const trace::RayTests tests = tracer.testsOf(engine, rays, dvec2(pixel) + 0.5);
    probe.tree.push_back(
        {-1, "eye ray", {{"hits", object, ""}, {"after", std::to_string(tracer.distance(rays, point)), "m"}}});
    if (engine.counts())
        probe.tree[0].facts.insert(probe.tree[0].facts.end(),
                                   {{"all rays try", std::to_string(tests.volumes), "volumes"},
                                    {"and", std::to_string(tests.triangles), "triangles"},
                                    {"looking into", std::to_string(tests.steps), "nodes, objects or cells"}});
    for (int l = 0; l < static_cast<int>(snapshot->lights.size()); ++l) {
        const std::string label = "shadow ray to " + snapshot->lights[static_cast<std::size_t>(l)].name;
        std::string answer = "arrives";
        if (!tracer.facesLight(point, l)) {
            answer = "not sent: faces away, or outside the light";
        } else if (!tracer.objectOf(point).receivesShadow) {
            answer = "not sent: receives no shadow";
        } else if (const std::uint32_t blocker = tracer.blocker(point, l); blocker != trace::kNoPrimitive) {
            answer = "blocked by " + snapshot->objects[tracer.world().objects[blocker]].name;
        }
        probe.tree.push_back({0, label, {{"result", answer, ""}}});
    }
    return probe;
}

} // namespace

std::span<const TechniqueInfo> techniques() {
    using enum scene::LightType;
    static const TechniqueInfo info[] = {{
        .id = "ray-traced",
        .title = "Ray tracing",
        .paper = "Appel 1968, Some Techniques for Shading Machine Renderings of Solids; Whitted 1980, An Improved "
                 "Illumination Model for Shaded Display",
        .getsWrong = "soft shadows (a light is a point); mirrors and glass are not followed",
        .order = 60,
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<RayTraced>(); },
    }};
    return info;
}

} // namespace shadowlab::ray_tracing
