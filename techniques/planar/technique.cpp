// SPDX-License-Identifier: MIT
#include "techniques/planar/technique.h"
#include "techniques/lights_in_view.h"

#include <algorithm>
#include <chrono>
#include <map>

#include "techniques/planar/described.h"

namespace shadowlab::planar {

Progress Planar::prepare(const scene::Snapshot& snapshot, Deadline deadline) {
    while (!receivers_.findNext(snapshot))
        if (std::chrono::steady_clock::now() >= deadline) return {0.3, false};
    casters_.update(snapshot);
    return {};
}

Progress Planar::render(Frame& frame) {
    const scene::Scene& scene = frame.scene();
    const int lights = static_cast<int>(scene.lights.size());
    buffers_.update(casters_);
    chooseFor(frame);

    // Shares of light and darkening twice are sums of radiance.
    if (params_.once && std::ranges::none_of(scene.lights, [&](const scene::Light& light) { return isSampled(light); }))
        frame.drawFinished(FinishedScenes::withLights);
    frame.pass(passInfo(kPasses, "lights-off"), [&] { passes_.lightsOff(frame); });
    if (frame.wants("lights-off")) frame.publishTarget("lights-off");
    frame.pass(passInfo(kPasses, "tag-receivers"), [&] {
        findHidden(frame);
        tagReceivers(frame, showsTags(frame) || !params_.cull);
    });
    if (frame.wants("stencil-tags")) publishTags(frame);
    countLists(frame);
    countServed(frame);

    Progress progress;
    std::map<int, int> mostShadowed; // per light: the number of the plane whose flattened geometry is shown
    for (int light = 0; light < lights; ++light) {
        const bool sampled = isSampled(scene.light(light));
        if (!sampled) counted_.erase(light);
        const bool isNeeded = !params_.cull || mayLight(frame, light);
        const bool looksAtMarks = frame.wants("shadow-marks", light) || frame.wants("flattened", light);
        frame.pass(
            passInfo(kPasses, "clear-marks"),
            [&] {
                if (light > 0) clearBits(kMarkBit | kLitBit);
            },
            light);
        if (!sampled || looksAtMarks)
            frame.pass(
                passInfo(kPasses, "shadows"),
                [&] {
                    if (isNeeded || looksAtMarks) markShadows(frame, lit_[static_cast<std::size_t>(light)]);
                },
                light);
        if (frame.wants("shadow-marks", light)) publishMarks(frame, light);
        if (frame.wants("flattened", light)) mostShadowed[light] = mostMarkedTag(frame);
        if (sampled)
            frame.pass(
                passInfo(kPasses, "count-points"),
                [&] {
                    if (looksAtMarks) clearBits(kMarkBit);
                    if (!countPoints(frame, light)) progress.converged = false;
                },
                light);
        if (frame.wants("points-in-shadow", light)) publishPoints(frame, light);
        if (frame.wants("visibility", light)) publishVisibility(frame, light);
        frame.pass(
            passInfo(kPasses, "light"),
            [&] {
                if (!isNeeded) return;
                if (frame.drawsFinished()) return passes_.hide(frame, light, std::nullopt, kMarkBit);
                gl::setAddLightState();
                drawLit(frame, sampled ? shadeCounted_ : passes_.light(), light);
            },
            light);
    }
    passes_.shadeFinished(frame, passInfo(kPasses, "light"));
    if (!params_.once)
        for (int light = 0; light < lights; ++light)
            frame.pass(
                passInfo(kPasses, "darken"), [&] { darken(frame, light); }, light);

    // Pictures over the finished image.
    if (frame.wants("receiver-planes")) publishPlanes(frame);
    for (const auto& [light, tag] : mostShadowed)
        if (frame.wants("flattened", light)) publishFlattened(frame, light, tag);
    return progress;
}

/// Chooses the receivers and lists their casters; keeps the former choice if the key is the same.
void Planar::chooseFor(const Frame& frame) {
    const scene::Scene& scene = frame.scene();
    const Region& region = frame.view().region;
    const scene::Revisions& now = scene.revisions;
    const ViewCacheKey view{now.geometry,      now.transforms, now.materials, frame.camera(),
                            frame.view().size, region.corner,  region.size,   gl::shaderReloads()};
    PictureCacheKey key{view, now.lights, params_};
    if (key == key_) return;
    key_ = std::move(key);
    inView_ = receivers_.inView(scene, frame.eye(), frame.buffers().bounds());
    std::erase_if(counted_, [&](const auto& kept) { return kept.first >= static_cast<int>(scene.lights.size()); });
    listFor(frame);
}

/// From what is in view.
void Planar::listFor(const Frame& frame) {
    const scene::Scene& scene = frame.scene();
    Choice choice = choose(inView_, params_.receivers, apartInPicture(frame.view().size),
                           hiddenIn_ == key_.view ? hidden_ : HiddenFaces{});
    chosen_ = std::move(choice.receivers);
    leftOut_ = choice.leftOut;
    lit_.clear();
    shadowedParts_.assign(chosen_.size(), scene::kNowhere);
    for (const scene::Light& light : scene.lights) {
        lit_.push_back(litPlanes(scene, chosen_, casters_, frame.eye(), scene::homogeneousPositionWorld(light), light,
                                 params_, false));
        for (const LitPlane& plane : lit_.back()) {
            scene::PicturePart& part = shadowedParts_[static_cast<std::size_t>(plane.receiver - chosen_.data())];
            part = around(part, plane.part);
        }
        if (!isSampled(light)) continue;
        for (std::size_t i = 0; i < chosen_.size(); ++i) // shadows of other points of the light fall elsewhere
            if (chosen_[i].lit) shadowedParts_[i] = around(shadowedParts_[i], chosen_[i].part);
    }
}

std::span<const TechniqueInfo> techniques() {
    using enum scene::LightType;
    static const TechniqueInfo info[] = {{
        .id = "planar",
        .title = "Planar projected shadows",
        .paper = "Blinn 1988, Me and My (Fake) Shadow",
        .getsWrong = "shadows on curved surfaces: there are none",
        .order = 10,
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .pseudocode = kProcedure,
        .values = {{"N·P + D = 0", "receiver plane"},
                   {"N·P_L + D", "N.P_L + D: height of the light"},
                   {"P_L", "light P_L, homogeneous"},
                   {"tag", "stencil number"}},
        .sweeps = {{.title = "Hard shadow"},
                   {.title = "Points of the light",
                    .varies = "light-samples",
                    .values = "4 16 64",
                    .quick = "16",
                    .lights = Sweep::Lights::withArea}},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<Planar>(); },
    }};
    return info;
}

} // namespace shadowlab::planar
