// Ray tracing: from the eye a ray through every pixel, and from the point that it hits a ray to every light.
//
// A. Appel, "Some Techniques for Shading Machine Renderings of Solids", 1968, traced these first rays; T. Whitted, "An Improved
// Illumination Model for Shaded Display", 1980, followed them on through mirrors and glass. A shadow ray asks for the definition of
// a shadow itself, "is anything between this point and the light?", so nothing is approximated: there is no map with texels and no
// count in a stencil. From pixels that show a mirror or glass a tree of rays is followed (ray_tree.h). With more than one sample, all
// of that is repeated with rays that are spread at random, and averaged (sampled_picture.h).
// Left out on purpose: light that mirrors and glass throw on other things (caustics).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <map>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/scene/id_buffer.h"
#include "techniques/frame.h"
#include "techniques/ray_tracing/described.h"
#include "techniques/ray_tracing/display/stages.h"
#include "techniques/ray_tracing/display/upload.h"
#include "techniques/ray_tracing/finished_picture.h"
#include "techniques/ray_tracing/params.h"
#include "techniques/ray_tracing/picture.h"
#include "techniques/ray_tracing/probe/pixel_probe.h"
#include "techniques/ray_tracing/probe/ray_shapes.h"
#include "techniques/ray_tracing/sampling/light_shares.h"
#include "techniques/ray_tracing/sampling/sampling_scene.h"
#include "techniques/ray_tracing/structures/ray_scene.h"
#include "techniques/ray_tracing/structures/structure_shapes.h"

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
        const Progress progress = scene_.prepare(snapshot, structureParams_, deadline);
        if (!progress.converged) return progress;
        return sampling_.prepare(snapshot, scene_.structures().chosen(), samplingParams_, deadline);
    }

    Progress render(Frame& frame) override {
        restartIfChanged(frame);
        frame.drawFinished(FinishedScenes::any);
        // Tracing draws nothing: a frame that stops after it is empty.
        gl::setBaselineState();
        frame.target().framebuffer.bind();
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        traceRays(frame);
        const bool hasAreas = picture_.isTraced() && traceAreas(frame);
        shade(frame, hasAreas);
        const bool hasFirst = hasAreas && traceTrees(frame);
        const bool isFinished = hasFirst && traceSamples(frame);
        const bool hasAnswers = !hasFirst || publishShares(frame);
        publishStages(frame, {scene_.tracer(), scene_.structures(), picture_, sampled_, shares_});
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
        if (view.picked) return {}; // the probe of that pixel has its rays
        std::vector<SceneShape> shapes = rayShapes(scene_.tracer(), view, light);
        // The tree of boxes is always there; a structure is drawn only where another one was chosen.
        if (scene_.structures().chosen() != trace::Structure::bvh)
            std::ranges::move(structureShapes(scene_.structures().engine(), scene_.structures().chosen(),
                                              scene_.tracer().world().originWorld, std::nullopt),
                              std::back_inserter(shapes));
        return shapes;
    }
    std::string remark(const scene::MeshReport& report, const scene::Mesh&) const override {
        return std::string("any triangles will do, closed or not, in any winding: rays meet them from both sides") +
               (report.hasHoles ? ", and pass through the holes that an alpha map cuts" : "");
    }

private:
    /// What a picture depends on: while it is equal, work that a deadline has interrupted is continued.
    struct PictureCacheKey {
        scene::Snapshot snapshot;
        scene::Camera camera;
        ivec2 size{0};
        std::optional<StageKey> stopsAfter;
        RayTracedParams params;
        StructureParams structureParams;
        SamplingParams samplingParams;
        friend bool operator==(const PictureCacheKey&, const PictureCacheKey&) = default;
    };

    /// What eye rays depend on: while it is equal, only the lights can have changed, and where those rays end is kept.
    struct EyeRaysKey {
        trace::SeenFrom seen;
        RayTracedParams params;
        StructureParams structureParams;
        friend bool operator==(const EyeRaysKey&, const EyeRaysKey&) = default;
    };

    void restartIfChanged(const Frame& frame) {
        const View& view = frame.view();
        PictureCacheKey key{frame.snapshot(), view.camera,      view.size,      frame.stopsAfter(),
                            params_,          structureParams_, samplingParams_};
        const bool goesOn = !isFinished_ && key == pictureKey_;
        isFinished_ = false;
        if (goesOn) return;
        pictureKey_ = std::move(key);
        const EyeRaysKey eyeRays{{frame.scene(), view.camera, view.size}, params_, structureParams_};
        if (eyeRays == eyeRaysKey_)
            picture_.restartLights(scene_.tracer());
        else
            picture_.restart(scene_.tracer(), view.camera, view.size);
        eyeRaysKey_ = eyeRays;
        sampled_.restart(samplingParams_.areMany() ? view.size : ivec2(0)); // its memory is large
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
            if (!picture_.isTraced()) picture_.trace(scene_.tracer(), settings, frame.deadline());
        });
        if (!isShaded_) counts_ = countRays(scene_.tracer(), picture_);
        publishCounts(frame, counts_);
    }

    /// The irradiance by lights with an area, in closed form. True when it is complete, or not asked for.
    bool traceAreas(Frame& frame) {
        if (!samplingParams_.isAnalytic()) return true;
        bool finished = true;
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light)
            if (const trace::AreaVisibility* area = sampling_.analytic()->area(light))
                frame.pass(
                    passInfo(kPasses, "areas"),
                    [&] {
                        LightShares& shares = sharesOf(light);
                        finished =
                            shares.advance(scene_.surfaces(), picture_, frame.view().camera, *area, frame.deadline()) &&
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

    /// Shades again while rays are still being traced, and when a single pass is shown; otherwise the shaded picture is kept.
    void shade(Frame& frame, bool tracedAll) {
        if (frame.drawsFinished() && !samplingParams_.isAnalytic() && !hasTrees() && !samplingParams_.areMany())
            return shadeFinished(frame);
        const Surfaces& surfaces = scene_.surfaces();
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

    /// All lights at once, in the last of the passes that shade.
    void shadeFinished(Frame& frame) {
        const int lights = static_cast<int>(frame.scene().lights.size());
        const auto shade = [&] {
            finished_.shade(scene_.surfaces(), picture_);
            uploadFromBelow(frame.finishedPicture(), finished_.fromBelow(), picture_.size());
        };
        frame.pass(passInfo(kPasses, "lights-off"), [&] {
            if (lights == 0) shade();
        });
        for (int light = 0; light < lights; ++light)
            frame.pass(
                passInfo(kPasses, "light"),
                [&] {
                    if (light + 1 == lights) shade();
                },
                light);
        isShaded_ = false; // radiance is still to be made, should it be asked for
    }

    [[nodiscard]] bool hasTrees() const {
        const TreeSettings tree = treeSettings();
        return (tree.depth > 0 && scene_.surfaces().anySplits()) || tree.attenuates();
    }

    /// True when the picture of one sample is finished, or the frame stops after an earlier pass.
    bool traceTrees(Frame& frame) {
        bool finished = true;
        if (hasTrees())
            frame.pass(passInfo(kPasses, "trees"), [&] {
                finished =
                    picture_.traceTrees({scene_.surfaces(), sampling_.atRest(), 0, nullptr, sampling_.analytic()},
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
                    sampled_.advance(scene_.surfaces(), sampling_.moving(), sampling_.analytic(), frame.view().camera,
                                     samplingParams_.settings(treeSettings(), frame.view().camera), frame.deadline());
            if (sampled_.isComplete()) show(frame, sampled_.radianceFromBelow());
        });
        frame.count("samples", sampled_.samplesInAll(),
                    static_cast<double>(picture_.points().size()) * samplingParams_.pattern.count, "rays");
        frame.count("secondary-rays", sampled_.secondaryRays());
        return finished;
    }

    /// The share of each light that pixels see, where a stage needs it. False: not yet known for all pixels.
    bool publishShares(Frame& frame) {
        bool finished = true;
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light) {
            if (!samplesArea(frame.scene(), light) ||
                !(frame.wants("visibility", light) || frame.wants("penumbra", light)))
                continue;
            if (samplingParams_.isAnalytic()) continue; // traceAreas() has found them
            finished = sharesOf(light).advance(scene_.surfaces(), picture_, frame.view().camera,
                                               samplingParams_.pattern, frame.deadline()) &&
                       finished;
        }
        return finished;
    }

    void show(const Frame& frame) { show(frame, picture_.radianceFromBelow()); }
    void show(const Frame& frame, const Grid<vec3>& radianceFromBelow) {
        if (!frame.drawsFinished()) return uploadFromBelow(frame.target().color, radianceFromBelow, picture_.size());
        finished_.encode(radianceFromBelow, frame.scene().exposure);
        uploadFromBelow(frame.finishedPicture(), finished_.fromBelow(), picture_.size());
    }

    /// Of trees without random numbers.
    [[nodiscard]] TreeSettings treeSettings() const {
        TreeSettings settings = params_.tree();
        if (samplingParams_.isAnalytic()) settings.areaLights = AreaLights::analytic;
        settings.skipsFaint = true;
        return settings;
    }

    RayTracedParams params_;
    StructureParams structureParams_;
    RayScene scene_;
    SamplingScene sampling_{scene_.tracer()};
    SamplingParams samplingParams_;

    PictureCacheKey pictureKey_; // of all that follows
    EyeRaysKey eyeRaysKey_;
    Picture picture_;
    SampledPicture sampled_;
    std::map<int, LightShares> shares_; ///< by light
    RayCounts counts_;
    FinishedPicture finished_;
    bool isShaded_ = false, isFinished_ = true;
    gl::IdBuffer idBuffer_;
};

/// By what the last frame was drawn with; without one it is prepared here.
Probe RayTraced::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe = Technique::probe(snapshot, view, pixel, light);
    prepare(snapshot, Deadline::max());
    const bool asksArea = light >= 0 && samplesArea(*snapshot, light);
    describePixel({scene_.tracer(), scene_.surfaces(), scene_.structures(), sampling_, samplingParams_, treeSettings(),
                   view, pixel, light, asksArea},
                  probe);
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
