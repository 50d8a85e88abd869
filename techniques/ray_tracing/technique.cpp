// Ray tracing, in its simplest form: from the eye through every pixel, and from what is seen there to every light.
//
// Appel, "Some Techniques for Shading Machine Renderings of Solids", 1968, sent the first rays from a point on paper
// through the holes of a plotter; Whitted, "An Improved Illumination Model for Shaded Display", 1980, made a recursion
// of it, by way of mirrors and glass. What is asked of shadow rays is the definition of a shadow itself, "is anything between
// this point and the light?", so nothing is approximated: no map with texels, no count in a stencil. Pixels that show
// neither mirror nor glass are done with that; from the others a tree of rays is followed (ray_tree.h).
// Left out on purpose: soft shadows (a light is a point), and light that mirrors and glass throw on other things.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/id_buffer.h"
#include "techniques/frame.h"
#include "techniques/ray_tracing/params.h"
#include "techniques/ray_tracing/picture.h"
#include "techniques/ray_tracing/picture_stages.h"
#include "techniques/ray_tracing/probe_tree.h"
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
    {"trees", "Follow the rays that mirrors and glass send on, and add what they bring",
     "At every surface a ray splits into a reflection and a refraction ray; their intensities are added up from the "
     "ends of "
     "the tree to its root. Pixels that show neither mirror nor glass stay as they are.",
     "none: the processor traces and shades; the picture is uploaded", false, "tree-depth"},
};

const StageInfo kStages[] = {
    {"primary-hits", "Where eye rays end: distance from the eye", StageKind::scalar, false},
    {"lights-off", "Scene with lights off", StageKind::radiance, false},
    {"shadow-rays", "What came of the shadow rays", StageKind::swatches, true},
    {"visibility", "Visibility of the light", StageKind::visibility, true},
    kTestsStage,
    kStructureStage,
    {"reflected", "What the reflection ray of each pixel adds", StageKind::radiance, false},
    {"transmitted", "What the refraction ray of each pixel adds", StageKind::radiance, false},
    {"tree-depth", "Levels of rays in the tree of each pixel", StageKind::scalar, false},
};

class RayTraced final : public Technique {
public:
    params::ParamList params() override {
        params::ParamList list = describe(params_);
        std::ranges::move(describe(structureParams_), std::back_inserter(list));
        return list;
    }
    Progress prepare(const scene::Snapshot& snapshot, Deadline deadline) override {
        tracer_.askInstead(nullptr);
        if (!tracer_.advance(snapshot, deadline)) return {tracer_.done(), false};
        // What is looked up of surfaces does not depend on lights, and they are what moves most.
        const scene::Revisions& now = snapshot->revisions;
        if (now.geometry != surfacesOf_.geometry || now.transforms != surfacesOf_.transforms ||
            now.materials != surfacesOf_.materials)
            surfaces_.emplace(tracer_);
        surfacesOf_ = now;
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
        settings.start = params_.start();
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
        if (frame.wants("primary-hits")) publishDistances(frame, tracer_, picture_);

        const Surfaces& surfaces = *surfaces_;
        frame.pass(passInfo(kPasses, "lights-off"), [&] {
            picture_.shadeLightsOff(surfaces);
            show(frame);
        });
        if (frame.wants("lights-off")) frame.publishTarget("lights-off");

        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light) {
            if (frame.wants("shadow-rays", light)) publishShadowRays(frame, picture_, light);
            if (frame.wants("visibility", light)) publishVisibility(frame, picture_, light);
            frame.pass(
                passInfo(kPasses, "light"),
                [&] {
                    picture_.shadeLight(surfaces, light);
                    show(frame);
                },
                light);
        }
        picture_.clearTrees();
        const TreeSettings tree = params_.tree();
        if ((tree.depth > 0 && surfaces.anySplits()) || tree.attenuates())
            frame.pass(passInfo(kPasses, "trees"), [&] {
                picture_.traceTrees(surfaces, frame.view().camera, tree);
                show(frame);
            });
        frame.count("trees", static_cast<double>(picture_.trees()), static_cast<double>(picture_.points().size()),
                    "pixels");
        frame.count("secondary-rays", static_cast<double>(picture_.secondaryRays()));
        if (frame.wants("reflected")) publishAdded(frame, "reflected", picture_, picture_.reflectedFromBelow());
        if (frame.wants("transmitted")) publishAdded(frame, "transmitted", picture_, picture_.transmittedFromBelow());
        if (frame.wants("tree-depth")) publishLevels(frame, picture_);
        if (frame.wants(kTestsStage.id)) publishTests(frame, tracer_, structures_);
        if (frame.wants(kStructureStage.id)) publishStructure(frame, tracer_, structures_, picture_);
        return {};
    }

    Probe probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) override;
    std::vector<SceneShape> shapes(const scene::Snapshot&, const View& view, int light) override {
        if (view.picked) return {}; // what its rays pass is in its probe
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

    RayTracedParams params_;
    StructureParams structureParams_;
    KeptStructures structures_;
    trace::SceneTracer tracer_;
    scene::Revisions surfacesOf_{0, 0, 0, 0}; ///< no scene has these
    std::optional<Surfaces> surfaces_;        ///< of a scene with these
    Picture picture_;
    gl::IdBuffer idBuffer_;
};

/// The rays of one pixel, as a tree: the eye ray, what it splits into, and at every surface a shadow ray for every light.
/// What the last frame was drawn with is used; without one it is made here.
Probe RayTraced::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe = Technique::probe(snapshot, view, pixel, light);
    prepare(snapshot, Deadline::max());
    const Surfaces& surfaces = *surfaces_;
    const trace::EyeRays rays = tracer_.eyeRays(view.camera, view.size);
    const dvec2 centre = dvec2(pixel) + 0.5;
    const trace::SurfacePoint point = tracer_.eyePoint(rays, centre);
    if (!point) return probe;
    const trace::Engine& engine = structures_.engine();
    const trace::RayTests tests = tracer_.testsOf(engine, rays, centre);
    if (engine.counts())
        probe.facts.insert(probe.facts.end(), {probeCount("eye ray and shadow rays try", tests.volumes, "volumes"),
                                               probeCount("and", tests.triangles, "triangles"),
                                               probeCount("looking into", tests.steps, "nodes, objects or cells")});
    trace::Ray toHit = rays.through(centre);
    toHit.farthest = tracer_.distance(rays, point) / glm::length(toHit.directionCentred);
    const std::vector<trace::StructurePart> passed = engine.passed(toHit, kMostPassed);
    if (!passed.empty())
        probe.facts.push_back(probeCount("the eye ray passes", passed.size(), passedWord(structures_.chosen())));
    // The tree of boxes is there even if nobody looks at it.
    if (!passed.empty() && structures_.chosen() != trace::Structure::bvh)
        probe.visited.push_back(passedShape(passed, structures_.chosen(), tracer_.world().originWorld));
    RayTree tree;
    tree.trace(surfaces, params_.tree(), rays.eyeCentred(), glm::normalize(rays.through(centre).directionCentred),
               point, surfaces.mediaAround(rays.eyeCentred()));
    describeTree(tree, surfaces, light, probe);
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
        .getsWrong = "soft shadows (a light is a point); light thrown by mirrors and glass (caustics)",
        .order = 60,
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<RayTraced>(); },
    }};
    return info;
}

} // namespace shadowlab::ray_tracing
