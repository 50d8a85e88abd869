// Radiosity: the light that diffuse surfaces send each other (C. Goral, K. Torrance, D. Greenberg and B. Battaile, "Modeling the
// Interaction of Light Between Diffuse Surfaces", SIGGRAPH 1984).
//
// 1. Every surface is cut into patches (room/room.h).
// 2. Form factors say what share of the light that leaves one patch reaches another: closed forms (point_form_factor.h,
//    rectangle_exchange.h) or quadrature (polygon_exchange.h), less what is blocked on the way (occlusion.h, visible_exchange.h).
// 3. Point, spot and other lights shine on the patches once (direct_light.h).
// 4. Every patch reflects what it receives from all others: a system of equations (problem.h), solved in one of six ways with a
//    bound of the error (solvers.h).
// 5. The solution does not depend on the eye; that only has a say in how large patches are (room/importance.h). A picture interpolates it between
//    patches (display/).
// 6. Direct light, whose shadows have edges, is found anew for each pixel (lights/pixel_light.h); patches keep what is reflected.
// Simplified on purpose: every surface is a Lambertian reflector, so mirrors, glass and highlights look dull; holes of alpha maps let
// no light through; meshes of many triangles exchange light as coarser ones.
// SPDX-License-Identifier: MIT
#include "techniques/exact_judge.h"
#include "techniques/foundation/gl/scene/surfaces.h"
#include "techniques/frame.h"
#include "techniques/probed/patch_exchange.h"
#include "techniques/radiosity/described.h"
#include "techniques/radiosity/display/light_map.h"
#include "techniques/radiosity/display/patch_error.h"
#include "techniques/radiosity/display/pixel_picture.h"
#include "techniques/radiosity/display/stages.h"
#include "techniques/radiosity/display/surface_picture.h"
#include "techniques/radiosity/lights/lamp_cover.h"
#include "techniques/radiosity/params.h"
#include "techniques/radiosity/probe.h"
#include "techniques/radiosity/solution.h"

namespace shadowlab::radiosity {

namespace {

class Radiosity final : public Technique {
public:
    params::ParamList params() override { return describe(params_); }

    Progress prepare(const scene::Snapshot& snapshot, Deadline deadline) override {
        if (params_.showsPixels()) return {}; // direct light can be drawn before there are patches
        if (!solution_->advanceRoom(snapshot, params_, deadline)) return {solution_->done(), false};
        return {};
    }

    Progress render(Frame& frame) override {
        // Direct light first: until the room is prepared it is all there is to show.
        std::optional<DirectShown> found = params_.showsPixels() ? advanceDirect(frame, frame.deadline()) : std::nullopt;
        const bool hasShownPatches = uploadedRoom_ != 0;
        if (const bool isFirst = !found || found->isFirst; isFirst && params_.showsPixels() && !hasShownPatches)
            return drawBeforehand(frame, found, solution_->done());
        const std::optional<Eye> eye = eyeOf(frame.view());
        if (!solution_->advanceRoom(frame.snapshot(), params_, frame.deadline(), eye) || !solution_->advanceDrawnFormFactors(params_, frame.deadline()))
            return drawBeforehand(frame, found, solution_->done());
        const bool isCutForEye = advanceCut(frame.snapshot(), eye, frame.deadline());
        if (uploadedRoom_ != solution_->cache().version()) picture_.setCells(solution_->cache().cells());
        uploadedRoom_ = solution_->cache().version();
        solution_->restartIfChanged(frame.snapshot(), params_);
        const Deadline deadline = std::max(frame.deadline(), std::chrono::steady_clock::now() + kLeastWork);
        const bool isSolved = solution_->advanceSolver(params_, static_cast<std::size_t>(params_.stepsPerPicture), deadline);
        if (!found || found->isPreview) found = advanceDirect(frame, deadline);
        const DirectShown direct = found.value_or(DirectShown()); // until then that of the patches
        const bool isDirectComplete = found && !found->isPreview;
        const bool mayGather = params_.gathers() && isCutForEye && isSolved && isDirectComplete;
        const bool isGathered = mayGather ? advanceGather(frame, deadline) : !params_.gathers();
        const bool isFinished = isCutForEye && isSolved && isDirectComplete && isGathered;
        if (!isFinished && !isNew(frame, direct, mayGather)) return {0.95, false};
        Showing showing{frame, solution_->cache(), solution_->sources(), solution_->balance(), picture_, params_, std::nullopt};
        if (isSolved) {
            showing.patchError = patchError_.share(solution_->cache(), solution_->sources(), solution_->balance(), params_.showsPixels(),
                                                   frame.view().camera.positionWorld);
            showing.caughtByLamps = shareCaughtByLamps(frame.scene().lights);
        }

        frame.pass(passInfo(kPasses, "patches"), [&] { clear(frame); });
        frame.pass(passInfo(kPasses, "form-factors"), [&] { clear(frame); });
        frame.pass(passInfo(kPasses, "emission"), [&] { drawEmission(frame); });
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light)
            frame.pass(
                passInfo(kPasses, "light"), [&] { drawLitBy(showing, light + 1); }, light);
        frame.pass(passInfo(kPasses, "solve"), [&] { drawSolution(showing); });
        if (!params_.isFlat()) frame.pass(passInfo(kPasses, "display"), [&] { drawReflected(showing, direct, mayGather && pixels_.hasGathered()); });
        for (int light = 0; direct.pixels && light < static_cast<int>(frame.scene().lights.size()); ++light)
            frame.pass(
                passInfo(kPasses, "direct"), [&] { direct.pixels->addDirect(frame, light, params_.exposureFactor()); }, light);

        if (isGathered && mayGather && params_.gather == RadiosityParams::Gather::shared)
            frame.count("gathering", static_cast<double>(pixels_.gathered()), frame.view().size.x * frame.view().size.y);
        publishStages(showing, direct);
        publishNotes(showing);
        return {isFinished ? 1.0 : 0.95, isFinished};
    }

    /// Of a light with an area, a patch knows the share that it sees.
    [[nodiscard]] bool samplesArea(const scene::Scene& scene, int light) const override {
        return scene::hasArea(scene.light(light));
    }
    Probe probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) override;
    std::string remark(const scene::MeshReport& report, const scene::Mesh& mesh) const override;

private:
    /// What the irradiance on the graphics card was made from.
    struct ShownCacheKey {
        std::uint64_t solution = 0, map = 0;
        bool withDirect = true;
        friend bool operator==(const ShownCacheKey&, const ShownCacheKey&) = default;
    };
    /// What the picture in the frame's target was drawn from.
    struct DrawnCacheKey {
        scene::Revisions revisions{0, 0, 0, 0};
        trace::SeenFrom seenFrom;
        Region region;
        std::uint64_t room = 0, solution = 0, map = 0, pixels = 0;
        bool showsPixels = false, isGathered = false;
        RadiosityParams params;
        friend bool operator==(const DrawnCacheKey&, const DrawnCacheKey&) = default;
    };

    [[nodiscard]] std::optional<Eye> eyeOf(const View& view) const {
        return params_.importance ? std::optional(Eye{view.camera, view.size}) : std::nullopt;
    }

    /// Are patches cut for this eye? If not, others are prepared, and the picture shows the ones before until they are.
    bool advanceCut(const scene::Snapshot& snapshot, const std::optional<Eye>& eye, Deadline deadline) {
        if (solution_->isCutFor(eye)) {
            next_.reset();
            return true;
        }
        if (!next_) next_ = std::make_unique<Solution>();
        if (!next_->advanceRoom(snapshot, params_, deadline, eye) || !next_->advanceDrawnFormFactors(params_, deadline)) return false;
        solution_ = std::move(next_);
        return solution_->isCutFor(eye); // the eye may have moved meanwhile
    }

    /// A picture for as long as form factors are still being found: the scene's ambient light, as an estimate of all that is reflected,
    /// and direct light, once the pixels have it.
    Progress drawBeforehand(Frame& frame, const std::optional<DirectShown>& found, double done) {
        if (!isNew(frame, found.value_or(DirectShown()), false)) return {done, false};
        frame.pass(passInfo(kPasses, "emission"), [&] {
            clear(frame);
            drawLightsOff(frame, frame.scene().ambient);
        });
        for (int light = 0; found && found->pixels && light < static_cast<int>(frame.scene().lights.size()); ++light)
            frame.pass(
                passInfo(kPasses, "direct"), [&] { found->pixels->addDirect(frame, light, params_.exposureFactor()); }, light);
        return {done, false};
    }

    /// The direct light of the pixels, at first as a preview, or the light map once that is complete; nothing before. Where the frame shows neither (the
    /// passes before `display` draw flat patches), it is that of the patches.
    std::optional<DirectShown> advanceDirect(const Frame& frame, Deadline deadline) {
        const auto& last = frame.stopsAfter();
        if (params_.isFlat() || (last && last->id != "display" && last->id != "direct")) return DirectShown();
        if (params_.direct == RadiosityParams::Direct::pixels) {
            const bool isComplete = pixels_.advanceDirect(frame.snapshot(), frame.view(), deadline);
            if (!pixels_.hasDirect()) return std::nullopt;
            return DirectShown{&pixels_, nullptr, !isComplete, pixels_.hasNewBlocks()};
        }
        if (params_.direct == RadiosityParams::Direct::lightMap) {
            if (!lightMap_.advance(frame.snapshot(), solution_->cache(), static_cast<std::size_t>(params_.lightMapPoints), deadline))
                return std::nullopt;
            return DirectShown{nullptr, &lightMap_, false};
        }
        return DirectShown();
    }

    /// Would the picture be another one than that which was drawn last? Drawing takes longer than a slice of the work that is left.
    bool isNew(const Frame& frame, const DirectShown& direct, bool mayGather) {
        const View& view = frame.view();
        DrawnCacheKey key{frame.scene().revisions,
                          trace::SeenFrom(frame.scene(), view.camera, view.size),
                          view.region,
                          uploadedRoom_,
                          solution_->balance().version(),
                          direct.map ? lightMap_.version() : 0,
                          pixels_.version(),
                          direct.pixels != nullptr,
                          mayGather && pixels_.hasGathered(),
                          params_};
        if (!frame.wantsOnlyPicture()) { // the target may then hold a part of the picture
            drawnKey_.reset();
            return true;
        }
        const bool isNew = !drawnKey_ || key != *drawnKey_;
        drawnKey_ = std::move(key);
        return isNew;
    }

    static void clear(const Frame& frame) {
        const vec3& background = frame.scene().background;
        glClearColor(background.r, background.g, background.b, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }

    void drawLightsOff(const Frame& frame, const vec3& ambient) const {
        gl::useLightsOff(lightsOff_, frame.scene(), frame.buffers(), ambient);
        gl::drawSurfacesWithHoles(lightsOff_, frame.scene(), frame.buffers(), frame.eye());
    }

    void drawEmission(const Frame& frame) const {
        clear(frame);
        drawLightsOff(frame, vec3(0.0f)); // ambient light stands for interreflection, which is computed here
    }

    /// Emission, and what of the first `lights` lights is reflected once. Seen only where the frame stops after this pass.
    void drawLitBy(const Showing& showing, int lights) const {
        if (!showing.frame.stopsAfter()) return;
        std::vector<dvec3> radiosity = solution_->sources().emission;
        for (int light = 0; light < lights; ++light)
            for (std::size_t i = 0; i < radiosity.size(); ++i)
                radiosity[i] += solution_->sources().reflectance[i] * solution_->cache().light(light).irradiance[i];
        showing.draw(radiosity, false);
    }

    /// Kept while the solution stays.
    double shareCaughtByLamps(std::span<const scene::Light> lights) {
        const Room& room = solution_->cache().room();
        const std::uint64_t version = solution_->balance().version();
        if (caught_.first != version) caught_ = {version, caughtByLamps(room.patches(), solution_->balance().radiosity(), lights, room.world().originWorld)};
        return caught_.second;
    }

    /// One value per patch. Pass `display` draws over it, unless the frame stops here.
    void drawSolution(const Showing& showing) const {
        if (showing.frame.stopsAfter() || params_.isFlat()) showing.draw(solution_->balance().radiosity(), false);
    }

    /// Kept while the solution stays.
    const GatherGuide& guide(const dvec3& outside) {
        const LightBalance& balance = solution_->balance();
        if (guide_.first != balance.version())
            guide_ = {balance.version(), GatherGuide(solution_->cache(), solution_->sources(), balance.radiosity(), outside)};
        return guide_.second;
    }

    /// True when all rays are sent, or the frame stops before what they gather is shown.
    bool advanceGather(const Frame& frame, Deadline deadline) {
        if (frame.stopsAfter() && frame.stopsAfter()->id != "display" && frame.stopsAfter()->id != "direct") return true;
        static const Openings kNone;
        const dvec3 outside = radianceOutside(*frame.snapshot(), params_);
        std::vector<dvec3> reflected = solution_->balance().irradianceShown();
        const bool asksOpenings = solution_->openings().bringMuch(outside, solution_->cache().room().patches(), reflected);
        for (std::size_t i = 0; i < reflected.size(); ++i)
            reflected[i] -= solution_->sources().fromLights[i];
        const GatherSolution solution{.cache = solution_->cache(),
                                      .sources = solution_->sources(),
                                      .guide = guide(outside),
                                      .openings = asksOpenings ? solution_->openings() : kNone,
                                      .reflectedIrradiance = reflected,
                                      .outside = outside,
                                      .version = solution_->balance().version()};
        const auto rays = static_cast<std::size_t>(params_.gatherSamples);
        if (params_.gather == RadiosityParams::Gather::pixels) return pixels_.advanceGather(solution, rays, deadline);
        return pixels_.advanceSharedGather(solution, rays, deadline);
    }

    /// What is reflected, as pixels have gathered it; until they have, interpolated between patches.
    void drawReflected(const Showing& showing, const DirectShown& direct, bool isGathered) {
        if (!isGathered) return drawSmooth(showing, direct);
        pixels_.drawGathered(showing.frame, params_.exposureFactor());
    }

    /// The irradiance stays on the graphics card while only the eye moves.
    void drawSmooth(const Showing& showing, const DirectShown& direct) {
        const ShownCacheKey key{solution_->balance().version(), direct.map ? lightMap_.version() : 0, !direct.pixels};
        if (!shown_ || shownKey_ != key) shown_ = showing.shown(direct);
        shownKey_ = key;
        showing.drawSmooth(*shown_);
    }

    [[nodiscard]] std::optional<std::uint32_t> partnerOf(std::uint32_t patch, const scene::Snapshot& snapshot,
                                                         const View& view) const;

    gl::Program lightsOff_{"surface.vert", "lights_off.frag"};
    RadiosityParams params_;
    std::unique_ptr<Solution> solution_ = std::make_unique<Solution>();
    std::unique_ptr<Solution> next_; ///< none: the patches are cut for the eye
    PatchError patchError_;
    std::pair<std::uint64_t, double> caught_{0, 0.0}; ///< the solution's version, and the share of its light that would meet lamps
    std::pair<std::uint64_t, GatherGuide> guide_{0, {}}; ///< the solution's version, and its guide
    LightMap lightMap_;
    SurfacePicture picture_;
    PixelPicture pixels_;
    std::uint64_t uploadedRoom_ = 0; ///< RoomCache::version() of the cells on the graphics card
    ShownCacheKey shownKey_;
    std::optional<DrawnCacheKey> drawnKey_;
    std::optional<ShownLight> shown_;
};

Probe Radiosity::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe = Technique::probe(snapshot, view, pixel, light);
    const std::optional<Eye> eye = eyeOf(view);
    solution_->advanceRoom(snapshot, params_, Deadline::max(), eye);
    if (params_.formFactors == RadiosityParams::FormFactors::analytic) // else they are drawn, with a picture
        while (!advanceCut(snapshot, eye, Deadline::max())) {
        }
    if (!exactJudge(snapshot)->eyeHit(view.camera, dvec2(pixel) + 0.5, view.size)) return probe;
    if (!solution_->cache().hasFormFactors()) {
        probe.facts.push_back(
            {"form factors", "drawn with the first picture; known without one with form-factors=analytic", ""});
        return probe;
    }
    solution_->restartIfChanged(snapshot, params_);
    if (params_.stepsPerPicture == 0) solution_->advanceSolver(params_, 0, Deadline::max());
    const auto patch = patchSeen(solution_->cache(), snapshot, view, pixel);
    if (!patch) {
        probe.facts.push_back({"patch", "none: a light, or the inside of a closed body", ""});
        return probe;
    }
    describePatch(solution_->cache(), solution_->sources(), solution_->balance(), *patch, light, partnerOf(*patch, snapshot, view), probe);
    if (view.partner && !probe.find<PatchExchange>()->k)
        probe.facts.push_back(
            {"k: the other patch", "none: the second pixel shows no other patch to exchange light with", ""});
    return probe;
}

/// The patch that the second pixel shows; without one, parameter `to-patch`, or the patch that sends the most light.
std::optional<std::uint32_t> Radiosity::partnerOf(std::uint32_t patch, const scene::Snapshot& snapshot,
                                                  const View& view) const {
    if (view.partner) return patchSeen(solution_->cache(), snapshot, view, *view.partner);
    if (params_.toPatch >= 0) return static_cast<std::uint32_t>(params_.toPatch);
    return patch < solution_->cache().room().patches().size() ? brightestGiver(solution_->cache(), solution_->balance(), patch) : std::nullopt;
}

std::string Radiosity::remark(const scene::MeshReport& report, const scene::Mesh& mesh) const {
    std::string text;
    if (mesh.triangles.size() > static_cast<std::size_t>(params_.patches) / 2)
        text = "too many triangles for patches of their own: light is exchanged by a coarser mesh";
    if (report.hasHoles)
        text += std::string(text.empty() ? "" : "; ") + "holes that an alpha map cuts let no light through";
    return text;
}

} // namespace

std::span<const TechniqueInfo> techniques() {
    using enum scene::LightType;
    static const TechniqueInfo info[] = {{
        .id = "radiosity",
        .title = "Radiosity",
        .paper = "Goral, Torrance, Greenberg and Battaile 1984, Modeling the Interaction of Light Between Diffuse "
                 "Surfaces; Cohen "
                 "and Greenberg 1985, The Hemi-Cube; Cohen, Chen, Wallace and Greenberg 1988, A Progressive Refinement "
                 "Approach to "
                 "Fast Radiosity Image Generation",
        .getsWrong = "everything that is not dull: mirrors, glass, highlights; what other surfaces send, where it changes faster than "
                     "patches are large",
        .order = 70,
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .pseudocode = kModel,
        .values = {{"B_j", "B, radiosity"},
                   {"E_j", "E, emitted"},
                   {"rho_j", "rho, reflected share"},
                   {"dA_j", "dA_j"},
                   {"dA_k", "dA_k"},
                   {"F_jk", "F_jk"},
                   {"F_kj", "F_kj"},
                   {"phi_j", "phi_j"},
                   {"phi_k", "phi_k"},
                   {"r", "r"},
                   {"irradiance of patch j by the light", "irradiance by lights"},
                   {"I", "I = B / pi, intensity"}},
        .sweeps = {{.title = "Direct light of pixels"},
                   {.title = "Direct light of patches",
                    .settings = "direct=patches",
                    .varies = "patches",
                    .values = "100 300 600 1200",
                    .quick = "300"},
                   {.title = "Light map", .settings = "direct=light-map", .onlyFull = true},
                   {.title = "Hemicubes", .settings = "form-factors=hemicube direct=patches", .onlyFull = true}},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<Radiosity>(); },
    }};
    return info;
}

} // namespace shadowlab::radiosity
