// `shadowlab measure`: what techniques get wrong, pixel by pixel, and what they cost.
// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "app/cli/json/measure_report.h"
#include "app/cli/messages.h"
#include "app/cli/progress.h"
#include "app/context/assets.h"
#include "app/context/signals.h"
#include "app/lab/settings.h"
#include "app/picture/limits.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::cli {

namespace {

/// Truth is visibility of a light: without one, there is nothing to be right or wrong about.
int lightToMeasure(const scene::Scene& scene, const std::string& asked, const std::string& name) {
    if (scene.lights.empty())
        throw Error(ExitStatus::badInput,
                    scene::shown(asked) + ": has no light whose shadows could be measured; add one under \"lights\"");
    return name.empty() ? 0 : picture::lightIndex(scene, name);
}

void requireVisibility(const TechniqueInfo& info) {
    if (publishes(info, kVisibilityStage)) return;
    throw Error(ExitStatus::usage, "'" + std::string(info.id) +
                                       "' does not say what it makes of one light, so it has no error to be measured; "
                                       "choose other techniques with -t");
}

void sayWhatIsProved(const judge::Counts& truth, const std::string& scene, const std::string& light) {
    if (truth.pixels == 0)
        note("no surface is in view, so nothing was measured");
    else if (truth.provesNothing())
        note("nothing in view of scene '" + scene + "' is " + (truth.lit == 0 ? "lit by" : "in the shadow of") + " '" +
             light + "', so this measurement proves nothing about shadows; choose another light, camera or scene");
    // More than one pixel in a thousand: the scene asks about the rasteriser's rounding rather than about shadows.
    if (truth.ties > truth.pixels / 1000)
        note(std::to_string(truth.ties) + " of " + std::to_string(truth.pixels) +
             " pixels are ties, more than one in a thousand: what lies there is not judged");
}

} // namespace

int measure(const MeasureOptions& options) {
    std::unique_ptr<context::Context> context; // before all that lives in it, so that it is destroyed after them
    std::vector<picture::Slot> slots;
    for (const std::string& id : options.techniques) {
        slots.push_back(picture::Session::makeSlot(id));
        requireVisibility(*slots.back().info);
    }
    lab::applySettings(slots, options.settings);
    const scene::Snapshot base = scene::loadScene(
        options.scene, {.assetsRoot = context::assetsRoot(), .allowed = options.allowed, .limits = picture::limits()});
    const int light = lightToMeasure(*base, options.scene, options.light);
    const film::Motion motion = motionOf(options.motion, *base);

    context = context::createContext(options.backend);
    if (const int limit = context::largestSide(); std::max(options.size.x, options.size.y) > limit)
        throw Error(ExitStatus::overLimit, "this OpenGL driver draws pictures of up to " + std::to_string(limit) +
                                               " pixels on a side; choose a smaller --size");
    picture::Session session(base);
    report::Measurement measurement(session, slots, light, options.size);
    Progress progress("frame", motion.frames);
    for (int frame = 0; frame < motion.frames; ++frame) {
        context::throwIfInterrupted();
        measurement.addFrame(film::momentAt(motion, base, frame));
        progress.done(frame + 1);
    }
    for (int turn = 0; turn < measurement.turns(); ++turn) {
        context::throwIfInterrupted();
        measurement.timeTurn(turn);
    }
    const Measured measured{
        base->name,   base->light(light).name, std::string(context->backend()), context::glRenderer(),
        options.size, motion.frames,           measurement.truthMs(),           measurement.results()};
    for (const std::string& remark : base->notes)
        note(remark);
    for (const std::string& remark : lab::settingsWithoutEffect(slots))
        note(remark);
    sayWhatIsProved(measured.results.front().counts, measured.scene, measured.light);
    print(options.json ? measureJson(measured) : measureTable(measured));
    return 0;
}

} // namespace shadowlab::cli
