// SPDX-License-Identifier: MIT
#include "app/picture/session.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "app/judge/metrics/frame_times.h"
#include "app/picture/derived_stages.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"

namespace shadowlab::picture {

using Clock = std::chrono::steady_clock;
using judge::elapsedMs;

Slot Session::makeSlot(std::string_view techniqueId) {
    const TechniqueInfo& info = findTechnique(techniqueId);
    Slot slot{&info, info.make(), {}, {}, {}};
    slot.params = slot.technique->params();
    return slot;
}

RenderedFrame Session::render(Slot& slot, const View& view, const FrameRequest& request) {
    buffers_.update(snapshot_);
    if (slot.target.size() != view.size) {
        slot.target = gl::Target(view.size, slot.info->id);
        slot.passes = 0;
    }

    RenderedFrame rendered;
    const Clock::time_point start = Clock::now();
    do {
        const Progress progress = slot.technique->prepare(snapshot_, request.deadline);
        rendered.converged = progress.converged;
        rendered.prepared = progress.converged ? 1 : progress.done;
    } while (!rendered.converged && Clock::now() < request.deadline);
    rendered.prepareMs = elapsedMs(start);
    if (!rendered.converged) return rendered; // nothing to draw yet: the target keeps what it showed

    View sampled = view; // a progressive technique gets one sample after the other
    do {
        Frame frame(snapshot_, sampled, buffers_, slot.target, request);
        const Progress progress = slot.technique->render(frame);
        rendered.converged = progress.converged;
        rendered.drawn = progress.converged ? 1 : progress.done;
        if (request.waitForGl) glFinish();
        rendered.frameMs = elapsedMs(start);
        rendered.result = frame.takeResult();
        ++sampled.sample;
        // In a hurry, what a pass has drawn for the first time is shown before anything gets better.
        const std::size_t passes = rendered.result.passes.size();
        const bool hasMore = passes > slot.passes;
        if (passes > 0) slot.passes = passes;
        if (hasMore && request.deadline != Deadline::max()) break;
    } while (!rendered.converged && request.refine && Clock::now() < request.deadline);
    return rendered;
}

const judge::Truth& Session::truth(const View& view, const LightTruth& light) {
    buffers_.update(snapshot_);
    return exact_.truth(snapshot_, buffers_, view, light);
}

LightTruth Session::truthFor(const Slot& slot, int light) const {
    const bool area = slot.technique->samplesArea(*snapshot_, light);
    return {light, area ? judge::TruthOf::area : judge::TruthOf::centre};
}

judge::Rasterised Session::rasterise(const View& view) {
    buffers_.update(snapshot_);
    return exact_.rasterise(snapshot_, buffers_, view);
}

bool isPublished(const RenderedFrame& rendered, const StageKey& key) {
    return std::ranges::find(rendered.result.stages, key, &Stage::key) != rendered.result.stages.end();
}

const Stage& findStage(const RenderedFrame& rendered, const StageKey& key) {
    const auto found = std::ranges::find(rendered.result.stages, key, &Stage::key);
    if (found == rendered.result.stages.end())
        throw std::logic_error("stage '" + key.id + "' was asked for and not published");
    return *found;
}

const StageInfo& stageInfo(const TechniqueInfo& info, std::string_view id) {
    const auto found = std::ranges::find(info.stages, id, &StageInfo::id);
    if (found == info.stages.end()) throw std::logic_error("no stage is described under the id " + std::string(id));
    return *found;
}

void requirePassRan(const RenderedFrame& rendered, const StageKey& pass, const TechniqueInfo& info) {
    if (std::ranges::find(rendered.result.passes, pass) != rendered.result.passes.end()) return;
    std::string ran;
    for (const StageKey& key : rendered.result.passes)
        if ((", " + ran + ",").find(", " + key.id + ",") == std::string::npos)
            ran += (ran.empty() ? "" : ", ") + key.id;
    throw Error(ExitStatus::usage, "pass '" + pass.id + "' of '" + std::string(info.id) +
                                       "' does not run with these settings; passes that run: " + ran);
}

int lightIndex(const scene::Scene& scene, std::string_view name) {
    std::vector<std::string> known;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (scene.lights[i].name == name) return static_cast<int>(i);
        known.push_back(scene.lights[i].name);
    }
    throw Error(ExitStatus::usage, "scene '" + scene.name + "' has no light '" + std::string(name) + "'; " +
                                       (known.empty() ? "it has no lights" : suggestion(name, known)));
}

} // namespace shadowlab::picture
