// Radiosity: what diffuse surfaces send each other (Goral, Torrance, Greenberg and Battaile, "Modeling the Interaction of Light
// Between Diffuse Surfaces", SIGGRAPH 1984).
//
// Every surface is cut into patches (room.h). Form factors say what share of one's light reaches another: closed forms
// (point_form_factor.h, rectangle_exchange.h) or quadrature (polygon_exchange.h), less what stands in between (occlusion.h,
// visible_exchange.h). Point, spot and other lights shine on the patches once (direct_light.h); then every patch reflects what
// it gets from every other one, for ever: a system of equations (problem.h), solved in one of six ways with a bound of the error
// (solvers.h). What comes out does not depend on where the eye is.
// Simplified on purpose: every surface is taken for a Lambertian one, so that mirrors, glass and highlights are as dull as the rest;
// holes of alpha maps let no light through; meshes of many triangles exchange light as coarser ones.
// SPDX-License-Identifier: MIT
#include "techniques/exact_judge.h"
#include "techniques/foundation/gl/scene/surfaces.h"
#include "techniques/frame.h"
#include "techniques/radiosity/described.h"
#include "techniques/radiosity/display/stages.h"
#include "techniques/radiosity/display/surface_picture.h"
#include "techniques/radiosity/equations/light_balance.h"
#include "techniques/radiosity/form_factors/hemicube_exchange.h"
#include "techniques/radiosity/lights/light_map.h"
#include "techniques/radiosity/params.h"
#include "techniques/radiosity/probe/probe.h"
#include "techniques/radiosity/probe/tell.h"
#include "techniques/radiosity/room/kept_room.h"

namespace shadowlab::radiosity {

namespace {

class Radiosity final : public Technique {
public:
    params::ParamList params() override { return describe(params_); }

    Progress prepare(const scene::Snapshot& snapshot, Deadline deadline) override {
        if (!kept_.advance(snapshot, params_, deadline)) return {kept_.done(), false};
        return {};
    }

    Progress render(Frame& frame) override {
        if (!kept_.hasFormFactors() && !drawFormFactors(frame.deadline())) {
            frame.pass(passInfo(kPasses, "patches"), [&] { clear(frame); });
            return {0.9 * hemicubes_->done(), false};
        }
        if (uploadedRoom_ != kept_.version()) picture_.setCells(kept_.cells());
        uploadedRoom_ = kept_.version();
        restartWhereNew(frame.snapshot());
        const Deadline deadline = std::max(frame.deadline(), std::chrono::steady_clock::now() + kLeastWork);
        const bool isSolved = solveOn(static_cast<std::size_t>(params_.stepsPerPicture), deadline);
        const bool isMapped =
            !wantsLightMap(frame) ||
            lightMap_.advance(frame.snapshot(), kept_, static_cast<std::size_t>(params_.lightMapPoints), deadline);
        const Showing showing{frame, kept_, sources_, balance_, picture_, params_};
        frame.pass(passInfo(kPasses, "patches"), [&] { clear(frame); });
        frame.pass(passInfo(kPasses, "form-factors"), [&] { clear(frame); });
        frame.pass(passInfo(kPasses, "emission"), [&] { drawEmission(frame); });
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light)
            frame.pass(
                passInfo(kPasses, "light"),
                [&] {
                    if (frame.stopsAfter()) showing.draw(litBy(light + 1), false);
                },
                light);
        frame.pass(passInfo(kPasses, "solve"), [&] {
            if (frame.stopsAfter() || isFlat()) showing.draw(balance_.radiosity(), false);
        });
        const LightMap* map = isMapped && usesLightMap() ? &lightMap_ : nullptr;
        if (!isFlat()) frame.pass(passInfo(kPasses, "display"), [&] { drawSmooth(showing, map); });
        publishStages(showing, map);
        tell(showing);
        const bool isFinished = isSolved && isMapped;
        return {isFinished ? 1.0 : 0.95, isFinished};
    }

    /// What the patches know of a light with an area is the share of it that they see.
    [[nodiscard]] bool samplesArea(const scene::Scene& scene, int light) const override {
        return scene::hasArea(scene.light(light));
    }
    Probe probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) override;
    std::string remark(const scene::MeshReport& report, const scene::Mesh& mesh) const override;

private:
    /// What the solution depends on: while it stays, solving goes on where it was.
    struct Made {
        std::uint64_t room = 0;
        scene::Revisions revisions{0, 0, 0, 0};
        SolverKind solver = SolverKind::direct;
        double tolerance = 0;
        int steps = 0, stepsPerPicture = 0;
        bool ambientTerm = true;
        RadiosityParams::Surroundings surroundings{};
        friend bool operator==(const Made&, const Made&) = default;
    };

    [[nodiscard]] bool isFlat() const { return params_.display == RadiosityParams::Display::flat; }
    [[nodiscard]] bool usesLightMap() const { return params_.display == RadiosityParams::Display::lightMap; }
    /// The step before it, stopped at, shows patches as they are.
    [[nodiscard]] bool wantsLightMap(const Frame& frame) const {
        return usesLightMap() && (!frame.stopsAfter() || frame.stopsAfter()->id == "display");
    }

    bool drawFormFactors(Deadline deadline) {
        const std::pair wanted{kept_.version(), params_.hemicubeSide};
        if (!hemicubes_ || hemicubesOf_ != wanted)
            hemicubes_ = std::make_unique<HemicubeExchange>(kept_.room().patches(), params_.hemicubeSide);
        hemicubesOf_ = wanted;
        if (!hemicubes_->advance(deadline)) return false;
        kept_.setDrawnFormFactors(hemicubes_->take(), params_.hemicubeSide);
        hemicubes_.reset();
        return true;
    }

    [[nodiscard]] std::optional<std::uint32_t> partnerOf(std::uint32_t patch, const scene::Snapshot& snapshot,
                                                         const View& view) const;

    void restartWhereNew(const scene::Snapshot& snapshot) {
        const Made made{kept_.version(), snapshot->revisions,     params_.solver,      params_.tolerance,
                        params_.steps,   params_.stepsPerPicture, params_.ambientTerm, params_.surroundings};
        if (made == made_) return;
        made_ = made;
        using enum RadiosityParams::Surroundings;
        const dvec3 outside(params_.surroundings == background ? snapshot->background
                            : params_.surroundings == ambient  ? snapshot->ambient
                                                               : vec3(0.0f));
        sources_ = sourcesOf(kept_.room(), kept_.lights(), outside);
        balance_.restart(kept_.exchange(), sources_, params_.solver, params_.ambientTerm);
    }

    /// True when it is solved, or has gone as far as it shall.
    bool solveOn(std::size_t most, Deadline deadline) {
        return balance_.advance({params_.tolerance, static_cast<std::size_t>(params_.steps)}, most, deadline);
    }

    /// Emission, and what of the first few lights is reflected once.
    [[nodiscard]] std::vector<dvec3> litBy(int lights) const {
        std::vector<dvec3> radiosity = sources_.emission;
        for (int light = 0; light < lights; ++light)
            for (std::size_t i = 0; i < radiosity.size(); ++i)
                radiosity[i] += sources_.reflectance[i] * kept_.light(light).irradiance[i];
        return radiosity;
    }

    static void clear(const Frame& frame) {
        const vec3& background = frame.scene().background;
        glClearColor(background.r, background.g, background.b, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
    void drawEmission(const Frame& frame) const {
        clear(frame);
        for (const gl::Program* program : {&lightsOff_.alphaTested(), &lightsOff_}) {
            program->use();
            program->set("ambient", vec3(0.0f)); // what it stands for is computed here
        }
        gl::drawSurfacesWithHoles(lightsOff_, frame.scene(), frame.buffers(), frame.eye());
    }
    /// What is shown stays on the graphics card while only the eye moves.
    void drawSmooth(const Showing& showing, const LightMap* map) {
        const ShownOf shownOf{balance_.version(), map ? lightMap_.version() : 0};
        if (!shown_ || shownOf_ != shownOf) shown_ = showing.shown(map);
        shownOf_ = shownOf;
        showing.drawSmooth(*shown_);
    }

    gl::Program lightsOff_{"surface.vert", "lights_off.frag"};
    RadiosityParams params_;
    KeptRoom kept_;
    std::unique_ptr<HemicubeExchange> hemicubes_; ///< while form factors are being drawn
    std::pair<std::uint64_t, int> hemicubesOf_;
    Made made_;
    Sources sources_;
    LightBalance balance_;
    LightMap lightMap_;
    SurfacePicture picture_;
    std::uint64_t uploadedRoom_ = 0;
    struct ShownOf {
        std::uint64_t solution = 0, map = 0;
        friend bool operator==(const ShownOf&, const ShownOf&) = default;
    };
    ShownOf shownOf_;
    std::optional<ShownLight> shown_;
};

Probe Radiosity::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe = Technique::probe(snapshot, view, pixel, light);
    prepare(snapshot, Deadline::max());
    if (!exactJudge(snapshot)->eyeHit(view.camera, dvec2(pixel) + 0.5, view.size)) return probe;
    if (!kept_.hasFormFactors()) {
        probe.facts.push_back(
            {"form factors", "drawn with the first picture; known without one with form-factors=analytic", ""});
        return probe;
    }
    restartWhereNew(snapshot);
    if (params_.stepsPerPicture == 0) solveOn(0, Deadline::max());
    const auto patch = patchSeen(kept_, snapshot, view, pixel);
    if (!patch) {
        probe.facts.push_back({"patch", "none: a light, or the inside of a closed body", ""});
        return probe;
    }
    describePatch(kept_, sources_, balance_, *patch, light, partnerOf(*patch, snapshot, view), probe);
    if (view.partner && !probe.exchange->k)
        probe.facts.push_back(
            {"k: the other patch", "none: the second pixel shows no other patch to exchange light with", ""});
    return probe;
}

/// The patch that the second pixel shows; without one, what the parameter says.
std::optional<std::uint32_t> Radiosity::partnerOf(std::uint32_t patch, const scene::Snapshot& snapshot,
                                                  const View& view) const {
    if (view.partner) return patchSeen(kept_, snapshot, view, *view.partner);
    if (params_.toPatch >= 0) return static_cast<std::uint32_t>(params_.toPatch);
    return patch < kept_.room().patches().size() ? brightestGiver(kept_, balance_, patch) : std::nullopt;
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
        .getsWrong = "everything that is not dull: mirrors, glass, highlights; shadows finer than its patches",
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
        .sweeps = {{.title = "Patches", .varies = "patches", .values = "100 300 600 1200", .quick = "300"},
                   {.title = "Hemicubes", .settings = "form-factors=hemicube", .onlyFull = true}},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<Radiosity>(); },
    }};
    return info;
}

} // namespace shadowlab::radiosity
