// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/volume_technique.h"

#include <algorithm>
#include <chrono>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/scene/query/view/visible_receivers.h"
#include "techniques/lights_in_view.h"
#include "techniques/probed/volume_probe.h"
#include "techniques/shadow_volume/cull/eye_line.h"
#include "techniques/shadow_volume/probe/shapes.h"

namespace shadowlab::shadow_volume {

namespace {

// Boxes around receivers in view. Every caster is tested against each of them, so more boxes would cost more than they
// save.
constexpr std::size_t kMostReceivers = 64;

} // namespace

Progress VolumeTechnique::prepare(const scene::Snapshot& snapshot, Deadline deadline) {
    while (!casters_.buildNext(snapshot, params_.construction))
        if (std::chrono::steady_clock::now() >= deadline) return {0.5, false};
    if (params_.repair && !repair_.prepare(snapshot, deadline)) return {0.9, false};
    return {};
}

Progress VolumeTechnique::render(Frame& frame) {
    const scene::Scene& scene = frame.scene();
    if (usesNearPlaneOfView()) frame.useNearPlaneOfView();
    if (failRule().farPlane) frame.useFarPlane();
    if (!params_.cull) frame.drawWhatIsOutOfView();
    frame.drawFinished(FinishedScenes::withLights);
    frame.pass(passInfo(counting_.passes, "lights-off"), [&] { passes_.lightsOff(frame); });
    if (frame.wants("lights-off")) frame.publishTarget("lights-off");

    frame.count("volumes-rebuilt", static_cast<double>(casters_.takeRebuilt()), static_cast<double>(casters_.count()));
    keepWhatRests(frame);
    const int lights = static_cast<int>(scene.lights.size());
    for (int light = 0; light < lights; ++light) {
        const bool isNeeded = !params_.cull || mayLight(frame, light);
        if (isNeeded) {
            chooseVolumes(frame, light);
        } else {
            chosen_ = {.volumes = {}, .part = scene::kNowhere};
            frame.count("volumes", 0, static_cast<double>(casters_.of(light).size()), "casters");
        }
        const bool isCounted = publishVisibility(frame, light);
        if (publishStencilStages(frame, light) || !isCounted) {
            clearAndCount(frame, light);
            repair(frame, light);
        }
        frame.pass(
            passInfo(counting_.passes, "light"),
            [&] {
                if (isNeeded) this->light(frame, light);
            },
            light);
    }
    passes_.shadeFinished(frame, passInfo(counting_.passes, "light"));
    for (int light = 0; light < lights; ++light)
        publishOverPicture(frame, light);
    return {};
}

/// While nothing moves, the chosen volumes and the pixels decided by rays stay valid, so they are kept: finding them again
/// would cost more than the rest of the frame.
void VolumeTechnique::keepWhatRests(const Frame& frame) {
    const View& view = frame.view();
    const auto [corner, size] = drawnRegion(view);
    CountCacheKey now{frame.snapshot(), view.camera,         view.size,          corner, size, params_,
                      rules(),          casters_.revision(), gl::shaderReloads()};
    const bool rests = now == countCacheKey_;
    repair_.beginFrame(rests);
    if (rests) return;
    countCacheKey_ = std::move(now);
    kept_.clear();
    findReceivers(frame.scene(), frame.eye());
}

void VolumeTechnique::findReceivers(const scene::Scene& scene, const gl::EyeMatrices& eye) {
    allReceiversInView_ = {};
    receiversInView_.clear();
    if (!params_.cull || !keepsToReceiversInView()) return;
    receiversInView_ = scene::visibleReceivers(scene, casters_.bounds(), eye.clipFromView * eye.viewFromWorld,
                                               eye.part.value_or(scene::PicturePart{}), kMostReceivers);
    for (const scene::Bounds& box : receiversInView_)
        allReceiversInView_.include(box);
}

VolumeEnd VolumeTechnique::endOf(const CasterVolume& caster, const scene::Light& light) const {
    VolumeEnd end;
    if (endsAtDistance()) end.distance = params_.extrusion;
    // A caster that shadows nothing (a floor) lies in the end plane itself. Top cap and bottom cap would then be too close
    // for the depth buffer to separate, so such a volume ends at infinity.
    if (params_.end != VolumeParams::End::receivers || !caster.useful) return end;
    if (!allReceiversInView_.isEmpty()) end.planeWorld = endPlaneWorld(caster.bounds, light, allReceiversInView_);
    if (!end.planeWorld) end.planeWorld = caster.endWorld;
    return end;
}

VolumeInView VolumeTechnique::inView(const gl::EyeMatrices& eye, const CasterVolume& caster,
                                     const scene::Light& light) const {
    const VolumeEnd end = endOf(caster, light);
    if (!params_.cull) return {.caster = &caster, .end = end};
    VolumeInView volume = volumeInView(caster, light, end, eye);
    if (volume.any && keepsToReceiversInView()) {
        if (missesAll(caster.bounds, light, allReceiversInView_))
            volume.any = false;
        else
            keepToReceivers(volume, light, receiversInView_, eye);
    }
    return volume;
}

/// A volume that shadows nothing may be left out, except in textbook depth pass: the eye may be in that volume.
bool VolumeTechnique::counts(const CasterVolume& caster, CountMethod method) const {
    return caster.useful || !params_.cull || (method == CountMethod::zPass && !passRule().corrected);
}

VolumeTechnique::ChosenVolumes VolumeTechnique::chosen(const Frame& frame, int light) {
    const std::vector<CasterVolume>& casters = casters_.upload(light);
    const scene::Light& source = frame.scene().light(light);
    ChosenVolumes chosen;
    for (std::size_t i = 0; i < casters.size(); ++i) {
        const CasterVolume& caster = casters[i];
        const CountMethod method = countMethodOf(frame.scene(), frame.camera().positionWorld, caster, light);
        const VolumeInView seen = inView(frame.eye(), caster, source);
        if (!seen.any || !counts(caster, method)) continue;
        chosen.volumes.push_back({.seen = seen, .method = method});
        if (params_.extrudeOn == VolumeParams::ExtrudeOn::cpu)
            chosen.volumes.back().extruded =
                &casters_.extrude(light, i, extrusionOf(frame.scene().objects[caster.object], source, seen.end));
        if (method == CountMethod::zPass && passRule().corrected)
            chosen.startCount += eyeCount(frame.scene(), caster, seen.end, source, frame.camera().positionWorld);
    }
    chosen.part = countedPart(chosen);
    return chosen;
}

/// The rectangle around all parts of volumes. An eye in a volume counts everywhere.
std::optional<scene::PicturePart> VolumeTechnique::countedPart(const ChosenVolumes& chosen) {
    scene::PicturePart all = scene::kNowhere;
    for (const CountedVolume& volume : chosen.volumes) {
        if (!volume.seen.part) return std::nullopt;
        all = around(all, *volume.seen.part);
    }
    return chosen.startCount == 0 ? std::optional(all) : std::nullopt;
}

void VolumeTechnique::chooseVolumes(Frame& frame, int light) {
    const auto known = kept_.find(light);
    chosen_ = known != kept_.end() ? known->second : kept_.emplace(light, chosen(frame, light)).first->second;
    frame.count("volumes", static_cast<double>(chosen_.volumes.size()), static_cast<double>(casters_.of(light).size()),
                "casters");
    const auto passing = std::ranges::count(chosen_.volumes, CountMethod::zPass, &CountedVolume::method);
    frame.count("depth-pass", static_cast<double>(passing), static_cast<double>(chosen_.volumes.size()), "volumes");
}

void VolumeTechnique::clearAndCount(Frame& frame, int light) {
    clearCount(frame, light);
    if (params_.twoSided) {
        count(frame, counting_.both, light);
    } else {
        count(frame, counting_.first, light);
        count(frame, counting_.second, light);
    }
}

// [anchor: clear-count]
void VolumeTechnique::clearCount(Frame& frame, int light) {
    frame.pass(
        passInfo(counting_.passes, "clear-stencil"),
        [&] {
            const bool isCleared = frame.drawsFinished() && light == 0 && chosen_.startCount == 0; // with colour and depth
            glClearStencil(chosen_.startCount);
            if (!isCleared) glClear(GL_STENCIL_BUFFER_BIT);
            if (countsInFloats(light)) floats_.clear(frame, chosen_.startCount);
        },
        light);
}

bool VolumeTechnique::countsInFloats(int light) const {
    using enum VolumeParams::Counter;
    if (params_.counter != automatic) return params_.counter == floats;
    // A smaller stencil, and one that saturates, are there to show their errors: floats must not replace them.
    constexpr int kMost = 255;
    return params_.stencil.wrap && params_.stencil.bits == 8 && casters_.overlaps(light) > kMost;
}

void VolumeTechnique::count(Frame& frame, const CountPass& pass, int light) {
    frame.pass(
        passInfo(counting_.passes, pass.id),
        [&] {
            glDepthMask(GL_FALSE);
            // [anchor: count-one-side]
            if (pass.culled != GL_NONE) {
                glEnable(GL_CULL_FACE);
                glCullFace(pass.culled);
            }
            if (countsInFloats(light)) {
                floats_.count(frame, counter_, light, chosen_.volumes, rules());
                floats_.writeStencil(frame);
                return;
            }
            frame.target().withoutColor.bind();
            glEnable(GL_STENCIL_TEST);
            counter_.countIntoStencil(frame, light, chosen_.volumes, rules(), params_.stencil);
        },
        light);
}

void VolumeTechnique::publishCount(Frame& frame, std::string_view stage, int light, bool bothSigns) {
    if (countsInFloats(light))
        pictures_.publishCount(frame, stage, light, floats_.read());
    else
        pictures_.publishCount(frame, stage, light, bothSigns);
}

void VolumeTechnique::repair(Frame& frame, int light) {
    if (!params_.repair) return;
    frame.pass(
        passInfo(counting_.passes, kRepairPass.id), [&] { repair_.apply(frame, light, chosen_.volumes, chosen_.part, params_.stencil); },
        light);
}

void VolumeTechnique::light(Frame& frame, int light) const {
    if (frame.drawsFinished()) {
        passes_.hide(frame, light, chosen_.part, params_.stencil.mask());
        return;
    }
    gl::setAddLightState();
    drawLit(frame, passes_.light(), light);
}

// [anchor: light-where-zero]
void VolumeTechnique::drawLit(Frame& frame, const gl::Program& program, int light) const {
    gl::useForLight(program, frame.scene(), frame.buffers(), frame.eye(), light);
    gl::drawSurfaces(program, frame.scene(), frame.buffers(), frame.eye(), [&](const scene::Object& object) {
        // Objects that receive no shadow ignore the count.
        glStencilFunc(object.receivesShadow ? GL_EQUAL : GL_ALWAYS, 0, params_.stencil.mask());
        return true;
    });
}

/// True if the stencil then holds the count, repaired. The stage is drawn on a copy of it: surfaces that are drawn mark their pixels
/// there, so that of several at one depth only the first is taken, and to count again takes longer than to copy.
bool VolumeTechnique::publishVisibility(Frame& frame, int light) {
    if (!frame.wants("visibility", light)) return false;
    clearAndCount(frame, light);
    repair(frame, light);
    frame.drawStageOnCopy("visibility", light, GL_RG32F, [&] {
        // First every surface as if it were in shadow, then those that the light reaches.
        glDepthFunc(GL_EQUAL);
        glDepthMask(GL_FALSE);
        glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
        gl::useForLight(visibility_, frame.scene(), frame.buffers(), frame.eye(), light);
        gl::drawSurfaces(visibility_, frame.scene(), frame.buffers(), frame.eye());
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        gl::setVisibilityState();
        drawLit(frame, visibility_, light);
    });
    return true;
}

/// True if any was asked for; the stencil then holds something else.
bool VolumeTechnique::publishStencilStages(Frame& frame, int light) {
    const std::string_view stages[] = {counting_.stageAfterFirst, "stencil", "crossings", "repair"};
    if (std::ranges::none_of(stages, [&](std::string_view stage) { return frame.wants(stage, light); })) return false;
    if (frame.wants(counting_.stageAfterFirst, light)) {
        clearCount(frame, light);
        count(frame, counting_.first, light);
        publishCount(frame, counting_.stageAfterFirst, light, false);
    }
    if (frame.wants("stencil", light)) {
        clearAndCount(frame, light);
        publishCount(frame, "stencil", light, true);
    }
    if (frame.wants("crossings", light)) {
        gl::setBaselineState();
        frame.scissorTo(std::nullopt);
        glDepthMask(GL_FALSE);
        floats_.clear(frame, 0);
        floats_.count(frame, counter_, light, chosen_.volumes, rules(), true);
        pictures_.publishCount(frame, "crossings", light, floats_.read());
    }
    if (frame.wants("repair", light)) {
        clearAndCount(frame, light);
        repair_.publish(frame, light, chosen_.volumes, chosen_.part, params_.stencil);
    }
    return true;
}

void VolumeTechnique::publishOverPicture(Frame& frame, int light) {
    const std::vector<const CasterVolume*> casters = usefulCasters(light);
    if (frame.wants("facing", light)) pictures_.publishFacing(frame, light);
    if (frame.wants("ways", light))
        pictures_.publishCountMethods(frame, light, casters, [&](const CasterVolume& caster) {
            return countMethodOf(frame.scene(), frame.camera().positionWorld, caster, light);
        });
    if (frame.wants("silhouettes", light)) pictures_.publishSilhouettes(frame, light, casters);
    const ShownVolume shown = shownVolume();
    if (frame.wants("volume-signs", light)) pictures_.publishFaces(frame, light, casters, false, shown);
    if (frame.wants("volume-parts", light)) pictures_.publishFaces(frame, light, casters, true, shown);
}

ShownVolume VolumeTechnique::shownVolume() const {
    ShownVolume shown{.construction = params_.construction, .distance = {}};
    if (endsAtDistance()) shown.distance = params_.extrusion;
    return shown;
}

std::vector<const CasterVolume*> VolumeTechnique::usefulCasters(int light) const {
    std::vector<const CasterVolume*> casters;
    for (const CasterVolume& caster : casters_.of(light))
        if (caster.useful || !params_.cull) casters.push_back(&caster);
    return casters;
}

std::vector<SceneShape> VolumeTechnique::shapes(const scene::Snapshot& snapshot, const View& view, int light) {
    const std::vector<const CasterVolume*> casters = usefulCasters(light);
    std::vector<SceneShape> shapes =
        volumeShapes(*snapshot, view, light, casters, failRule().caps && showsCaps(), shownVolume());
    if (showsCountMethods())
        addCountMethods(shapes, casters, [&](const CasterVolume& caster) {
            return countMethodOf(*snapshot, view.camera.positionWorld, caster, light);
        });
    return shapes;
}

std::string VolumeTechnique::remark(const scene::MeshReport& report, const scene::Mesh&) const {
    // A volume is bounded by edges of the mesh. The border of a hole is no edge, so holes cast as solid.
    const std::string holes = report.hasHoles ? "; holes cut by its alpha map are cast as solid" : "";
    if (report.isClosed()) return "closed: every silhouette edge separates two faces" + holes;
    return "not closed (" + std::to_string(report.boundaryEdges) + " boundary, " +
           std::to_string(report.multipleEdges) + " multiple, " + std::to_string(report.inconsistentEdges) +
           " inconsistently wound edges): handled exactly by signed edge counts" + holes;
}

} // namespace shadowlab::shadow_volume
