// Ray tracing, in its simplest form: from the eye through every pixel, and from what is seen there to every light.
//
// Appel, "Some Techniques for Shading Machine Renderings of Solids", 1968, sent the first rays from a point on paper
// through the holes of a plotter; Whitted, "An Improved Illumination Model for Shaded Display", 1980, made a recursion
// of it, by way of mirrors and glass. What is asked of shadow rays is the definition of a shadow itself, "is anything between
// this point and the light?", so nothing is approximated: no map with texels, no count in a stencil. Pixels that show
// neither mirror nor glass are done with that; from the others a tree of rays is followed (ray_tree.h). With more than one
// sample, all that is done again and again with rays that chance has spread (sampled_picture.h).
// Left out on purpose: light that mirrors and glass throw on other things.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <map>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/scene/id_buffer.h"
#include "techniques/frame.h"
#include "techniques/ray_tracing/described.h"
#include "techniques/ray_tracing/params.h"
#include "techniques/ray_tracing/picture.h"
#include "techniques/ray_tracing/picture_stages.h"
#include "techniques/ray_tracing/probe/probe_area.h"
#include "techniques/ray_tracing/probe/probe_samples.h"
#include "techniques/ray_tracing/probe/probe_structure.h"
#include "techniques/ray_tracing/probe/probe_tree.h"
#include "techniques/ray_tracing/probe/ray_shapes.h"
#include "techniques/ray_tracing/sampling/light_shares.h"
#include "techniques/ray_tracing/sampling/sampling_scene.h"
#include "techniques/ray_tracing/structures/naive_intersection.h"
#include "techniques/ray_tracing/structures/structure_params.h"
#include "techniques/ray_tracing/structures/structure_shapes.h"
#include "techniques/ray_tracing/structures/structure_stages.h"
#include "techniques/ray_tracing/upload.h"

namespace shadowlab::ray_tracing {

namespace {

class RayTraced final : public Technique {
public:
    params::ParamList params() override {
        params::ParamList list = describe(params_);
        std::ranges::move(describe(structureParams_), std::back_inserter(list));
        std::ranges::move(describe(samplingParams_), std::back_inserter(list));
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
        if (!progress.converged) return progress;
        if (structures_.chosen() != trace::Structure::bvh) tracer_.askInstead(&structures_.engine());
        naive_.reset();
        if (structureParams_.intersection == StructureParams::Intersection::naive) {
            naive_ = makeNaiveEngine(tracer_.geometry()->bvh, static_cast<float>(structureParams_.edgeMargin));
            tracer_.askInstead(naive_.get());
        }
        return sampling_.prepare(snapshot, structures_.chosen(), samplingParams_, deadline);
    }

    Progress render(Frame& frame) override {
        beginOrGoOn(frame);
        // Tracing draws nothing: who stops after it sees an empty picture.
        gl::setBaselineState();
        frame.target().framebuffer.bind();
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        traceRays(frame);
        const bool hasAreas = picture_.isTraced() && traceAreas(frame);
        shade(frame, hasAreas);
        const bool hasFirst = hasAreas && traceTrees(frame);
        const bool isFinished = hasFirst && traceSamples(frame);
        const bool hasAnswers = !hasFirst || publishShares(frame);
        publishStages(frame);
        isFinished_ = isFinished && hasAnswers;
        if (isFinished_) return {};
        if (!frame.refines()) return {picture_.done(hasTrees()), false};
        return {hasFirst && samplingParams_.areMany() ? sampled_.done() : picture_.done(hasTrees()), false};
    }

    [[nodiscard]] bool samplesArea(const scene::Scene& scene, int light) const override {
        const bool sampled =
            samplingParams_.areMany() && samplingParams_.softShadows == SamplingParams::SoftShadows::sampled;
        return (sampled || samplingParams_.isAnalytic()) && scene::hasArea(scene.light(light));
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
    /// What a picture is made of: while it stays, work that a deadline has interrupted goes on.
    struct Made {
        scene::Snapshot snapshot;
        scene::Camera camera;
        ivec2 size{0};
        std::optional<StageKey> stopsAfter;
        RayTracedParams params;
        StructureParams structureParams;
        SamplingParams samplingParams;
        friend bool operator==(const Made&, const Made&) = default;
    };

    void beginOrGoOn(const Frame& frame) {
        const View& view = frame.view();
        Made made{frame.snapshot(), view.camera,      view.size,      frame.stopsAfter(),
                  params_,          structureParams_, samplingParams_};
        const bool goesOn = !isFinished_ && made == made_;
        isFinished_ = false;
        if (goesOn) return;
        made_ = std::move(made);
        picture_.restart(tracer_, view.camera, view.size);
        sampled_.restart(samplingParams_.areMany() ? view.size : ivec2(0)); // it takes much memory
        shares_.clear();
        isShaded_ = false;
    }

    void traceRays(Frame& frame) {
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
        frame.pass(passInfo(kPasses, "visibility"), [&] {
            if (!picture_.isTraced()) picture_.trace(tracer_, settings, frame.deadline());
        });
        if (!isShaded_) counts_ = countRays(tracer_, picture_);
        publishCounts(frame, counts_);
    }

    /// What the areas of lights bring, in closed form, where that is wanted.
    bool traceAreas(Frame& frame) {
        if (!samplingParams_.isAnalytic()) return true;
        bool finished = true;
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light)
            if (const trace::AreaVisibility* area = sampling_.analytic()->area(light))
                frame.pass(
                    passInfo(kPasses, "areas"),
                    [&] {
                        LightShares& shares = sharesOf(light);
                        finished = shares.advance(*surfaces_, picture_, frame.view().camera, *area, frame.deadline()) &&
                                   finished;
                    },
                    light);
        return finished;
    }
    LightShares& sharesOf(int light) {
        LightShares& shares = shares_[light];
        if (shares.light() != light) shares.restart(picture_.size(), light);
        return shares;
    }

    /// Anew while rays are still being traced, and when somebody looks at a part of it; else what is shaded stays.
    void shade(Frame& frame, bool tracedAll) {
        const Surfaces& surfaces = *surfaces_;
        const int lights = static_cast<int>(frame.scene().lights.size());
        const bool stays = isShaded_ && !frame.wants("lights-off") && !frame.stopsAfter();
        frame.pass(passInfo(kPasses, "lights-off"), [&] {
            if (!stays) picture_.shadeLightsOff(surfaces);
            if (lights == 0 || frame.wants("lights-off") || frame.stopsAfter()) show(frame);
        });
        if (frame.wants("lights-off")) frame.publishTarget("lights-off");
        for (int light = 0; light < lights; ++light)
            frame.pass(
                passInfo(kPasses, "light"),
                [&] {
                    if (!stays && samplingParams_.isAnalytic() && sampling_.analytic()->area(light))
                        picture_.shadeAreaLight(surfaces, light, sharesOf(light).irradiances());
                    else if (!stays)
                        picture_.shadeLight(surfaces, light);
                    if (light + 1 == lights || frame.stopsAfter()) show(frame);
                },
                light);
        isShaded_ = tracedAll;
    }

    [[nodiscard]] bool hasTrees() const {
        const TreeSettings tree = treeSettings();
        return (tree.depth > 0 && surfaces_->anySplits()) || tree.attenuates();
    }

    /// True when the first picture is finished; also where nobody looks at what comes after an earlier step.
    bool traceTrees(Frame& frame) {
        bool finished = true;
        if (hasTrees())
            frame.pass(passInfo(kPasses, "trees"), [&] {
                finished = picture_.traceTrees({*surfaces_, sampling_.atRest(), 0, nullptr, sampling_.analytic()},
                                               treeSettings(), frame.deadline());
                show(frame);
            });
        frame.count("trees", static_cast<double>(picture_.trees()), static_cast<double>(picture_.points().size()),
                    "pixels");
        frame.count("secondary-rays", static_cast<double>(picture_.secondaryRays()));
        return finished;
    }

    bool traceSamples(Frame& frame) {
        if (!samplingParams_.areMany()) return true;
        bool finished = true;
        frame.pass(passInfo(kPasses, "samples"), [&] {
            finished = false;
            if (frame.refines())
                finished =
                    sampled_.advance(*surfaces_, sampling_.moving(), sampling_.analytic(), frame.view().camera,
                                     samplingParams_.settings(treeSettings(), frame.view().camera), frame.deadline());
            if (sampled_.isComplete())
                uploadFromBelow(frame.target().color, sampled_.radianceFromBelow(), sampled_.size());
        });
        frame.count("samples", sampled_.samplesInAll(),
                    static_cast<double>(picture_.points().size()) * samplingParams_.pattern.count, "rays");
        frame.count("secondary-rays", sampled_.secondaryRays());
        return finished;
    }

    /// The share of each light that pixels see, where somebody wants to know it. False: not found for all of them yet.
    bool publishShares(Frame& frame) {
        bool finished = true;
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light) {
            if (!samplesArea(frame.scene(), light) ||
                !(frame.wants("visibility", light) || frame.wants("penumbra", light)))
                continue;
            if (samplingParams_.isAnalytic()) continue; // found already
            finished = sharesOf(light).advance(*surfaces_, picture_, frame.view().camera, samplingParams_.pattern,
                                               frame.deadline()) &&
                       finished;
        }
        return finished;
    }

    void publishStages(Frame& frame) {
        if (frame.wants("primary-hits")) publishDistances(frame, tracer_, picture_);
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light) {
            const auto shares = shares_.find(light);
            if (frame.wants("shadow-rays", light)) publishShadowRays(frame, picture_, light);
            if (frame.wants("visibility", light))
                publishVisibility(frame, picture_, light, shares == shares_.end() ? nullptr : &shares->second);
            if (frame.wants("penumbra", light))
                publishPenumbra(frame, picture_, light, shares == shares_.end() ? nullptr : &shares->second);
        }
        if (frame.wants("reflected")) publishAdded(frame, "reflected", picture_, picture_.reflectedFromBelow());
        if (frame.wants("transmitted")) publishAdded(frame, "transmitted", picture_, picture_.transmittedFromBelow());
        if (frame.wants("tree-depth")) publishLevels(frame, picture_);
        if (frame.wants("samples-per-pixel")) publishSamples(frame, picture_, sampled_);
        if (frame.wants(kTestsStage.id)) publishTests(frame, tracer_, structures_);
        if (frame.wants(kStructureStage.id)) publishStructure(frame, tracer_, structures_, picture_);
    }

    void show(const Frame& frame) const {
        uploadFromBelow(frame.target().color, picture_.radianceFromBelow(), picture_.size());
    }

    /// Of a tree that is not left to chance.
    [[nodiscard]] TreeSettings treeSettings() const {
        TreeSettings settings = params_.tree();
        if (samplingParams_.isAnalytic()) settings.areaLights = AreaLights::analytic;
        settings.skipsFaint = true;
        return settings;
    }

    RayTracedParams params_;
    StructureParams structureParams_;
    KeptStructures structures_;
    std::unique_ptr<trace::Engine> naive_; ///< asked instead of the structure, if at all
    trace::SceneTracer tracer_;
    scene::Revisions surfacesOf_{0, 0, 0, 0}; ///< no scene has these
    std::optional<Surfaces> surfaces_;        ///< of a scene with these
    SamplingScene sampling_{tracer_};
    SamplingParams samplingParams_;

    Made made_; ///< of this are:
    Picture picture_;
    SampledPicture sampled_;
    std::map<int, LightShares> shares_; ///< by light
    RayCounts counts_;
    bool isShaded_ = false, isFinished_ = true;
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
    if (samplingParams_.areMany())
        describeSamples({surfaces, sampling_.moving(), sampling_.analytic(), view.camera, view.size, pixel, light},
                        samplingParams_.settings(treeSettings(), view.camera), point, probe);
    if (!point) return probe;
    const trace::Engine& engine = structures_.engine();
    const trace::RayTests tests = tracer_.testsOf(engine, rays, centre);
    if (engine.counts())
        probe.facts.insert(probe.facts.end(), {probeCount("eye ray and shadow rays try", tests.volumes, "volumes"),
                                               probeCount("and", tests.triangles, "triangles"),
                                               probeCount("looking into", tests.steps, "nodes, objects or cells")});
    trace::Ray toHit = rays.through(centre);
    toHit.farthest = tracer_.distance(rays, point) / glm::length(toHit.directionCentred);
    describeStructure(tracer_, engine, toHit, probe);
    const std::vector<trace::StructurePart> passed = engine.passed(toHit, kMostPassed);
    if (!passed.empty())
        probe.facts.push_back(probeCount("the eye ray passes", passed.size(), passedWord(structures_.chosen())));
    // The tree of boxes is there even if nobody looks at it.
    if (!passed.empty() && structures_.chosen() != trace::Structure::bvh)
        probe.visited.push_back(passedShape(passed, structures_.chosen(), tracer_.world().originWorld));
    const dvec3 u = glm::normalize(rays.through(centre).directionCentred);
    if (light >= 0 && samplesArea(*snapshot, light)) describeArea(surfaces, point, -u, light, probe);
    if (samplingParams_.areMany())
        probe.facts.push_back({"the picture",
                               "the mean of " + std::to_string(samplingParams_.pattern.count) +
                                   " such trees, spread by chance; this one goes through the middle of "
                                   "everything, at time 0",
                               ""});
    RayTree tree;
    TreeSettings settings = treeSettings();
    settings.skipsFaint = false;
    tree.trace({surfaces, sampling_.atRest(), 0, nullptr, sampling_.analytic()}, settings, rays.eyeCentred(), u, point,
               surfaces.mediaAround(rays.eyeCentred()));
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
                 "Illumination Model for Shaded Display; Cook, Porter and Carpenter 1984, Distributed Ray Tracing",
        .getsWrong = "light thrown by mirrors and glass (caustics); with few samples noise",
        .order = 60,
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .pseudocode = kRayCastingSteps,
        .values = {{"I_R", "I_R"},
                   {"I_T", "I_T"},
                   {"weight of I_R", "weight of I_R"},
                   {"weight of I_T", "weight of I_T"},
                   {"attenuation", "attenuation"},
                   {"own light", "own light"},
                   {"u", "u"},
                   {"N", "N"},
                   {"R", "R"},
                   {"H", "H"},
                   {"toViewerWorld", "V"},
                   {"visibility", "truth"}},
        .sweeps = {{.title = "Shadow rays"},
                   {.title = "Receivers from an id buffer", .settings = "receivers=id-buffer"},
                   {.title = "In a grid", .settings = "structure=grid", .onlyFull = true},
                   {.title = "Points of the light",
                    .settings = "antialias=false", // visibility is asked for at the pixel's centre
                    .varies = "samples",
                    .values = "4 16 64",
                    .quick = "16",
                    .lights = Sweep::Lights::withArea},
                   {.title = "Light in closed form",
                    .settings = "soft-shadows=analytic",
                    .lights = Sweep::Lights::withArea}},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<RayTraced>(); },
    }};
    return info;
}

} // namespace shadowlab::ray_tracing
