// `shadowlab measure`: what techniques get wrong, pixel by pixel, and what they cost.
// SPDX-License-Identifier: MIT
#include "app/cli/measure.h"
#include "app/lab/old_spelling.h"

#include <optional>

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/cli/json/measure_report.h"
#include "app/cli/messages.h"
#include "app/cli/motion_options.h"
#include "app/cli/option_values.h"
#include "app/cli/progress.h"
#include "app/context/signals.h"
#include "app/lab/settings.h"
#include "app/picture/limits.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/query/view/empty_view.h"
#include "techniques/registry.h"

namespace shadowlab::cli {

namespace {

struct MeasureOptions {
    std::string scene;
    std::vector<std::string> techniques{"shadow-volume-zfail"};
    ivec2 size{1280, 720};
    std::vector<std::string> settings; ///< [SLOT:]ID.PARAM=VALUE
    std::string light;                 ///< empty: the first
    std::string view;                  ///< empty: the scene's own camera
    context::Backend backend = context::Backend::automatic;
    MotionOptions motion;
    report::CoverageAsked coverage;
    bool json = false;
    std::optional<scene::NormalMode> normals; ///< of a mesh; none: as it has them
    std::vector<std::filesystem::path> allowed;
};

void describeMeasure(DescribedOptions& add) {
    describeScene(add);
    add.option("-t,--technique", "ID[,ID...]",
               "techniques (`list techniques`; default shadow-volume-zfail), all, or lecture for the lecture's own");
    add.option("--size", "WxH", "width and height in pixels (default 1280x720)");
    add.option("--set", "[SLOT:]ID.PARAM=VALUE",
               "a parameter (`list parameters`), of all slots or of one; may be repeated");
    add.option("--light", "NAME", "the light whose shadows are judged (default: the first)");
    describeView(add);
    describeBackend(add);
    describeMotion(add);
    add.option("--subpixel", "N",
               "judges the share of each pixel that is lit as well, by N points of it, 1 to 256 (docs/measuring.md)");
    add.option("--supersample", "N",
               "with --subpixel: N x N samples of each pixel, whose mean is the technique's answer (default 1)");
    add.flag("--json", "one JSON object instead of a table");
    describeNormals(add);
    add.option("--allow", "DIR", "a further folder that the scene may take meshes from; may be repeated");
    add.footer("Times are medians over the frames; errors are those of the first frame; flips are of all frames.\n"
               "Examples:\n"
               "  shadowlab measure still-life -t all\n"
               "  shadowlab measure bunny.obj -t shadow-map --set shadow-map.resolution=512 --json\n"
               "  shadowlab measure still-life -t shadow-map --frames 60 --orbit-light 6\n"
               "  shadowlab measure still-life -t shadow-map --set shadow-map.filter=pcf --subpixel 32");
}

/// Of shares of pixels. Samples without them would be drawn and not looked at.
report::CoverageAsked coverageFrom(const GivenOptions& given) {
    if (!given.has("--subpixel")) {
        if (given.has("--supersample"))
            refuseUsage("--supersample is about the share of a pixel that is lit; add --subpixel N");
        return {};
    }
    return {countFrom("--subpixel", given.text("--subpixel"), judge::kMostSubpixelPoints),
            limitedCountFrom("--supersample", given.text("--supersample", "1"), "supersample")};
}

MeasureOptions measureOptions(const GivenOptions& given) {
    MeasureOptions options;
    options.scene = given.required("SCENE", "shadowlab measure SCENE");
    if (given.has("--technique")) options.techniques = measuredTechniquesFrom(given.texts("--technique"));
    options.size = sizeFrom("--size", given.text("--size", "1280x720"), "measured-side");
    options.coverage = coverageFrom(given);
    reserveForMeasured(options.size, options.coverage.samples);
    options.settings = given.texts("--set");
    lab::respell(options.techniques, {}, options.settings);
    options.light = given.text("--light");
    options.view = given.text("--view");
    options.backend = backendFrom(given);
    options.motion = motionOptions(given);
    options.json = given.has("--json");
    options.allowed = given.allowedFolders();
    options.normals = normalsFrom(given, options.scene);
    return options;
}

void requireVisibility(const TechniqueInfo& info) {
    if (publishes(info, kVisibilityStage)) return;
    throw Error(ExitStatus::usage, "'" + std::string(info.id) +
                                       "' does not say what it makes of one light, so it has no error to be measured; "
                                       "choose other techniques with -t");
}

void sayWhatIsProved(const judge::Counts& truth, const film::Moment& seen, ivec2 size, const std::string& scene,
                     const std::string& light) {
    if (truth.pixels == 0) {
        const std::string why = scene::whyNothingIsSeen(*seen.snapshot, seen.camera, size);
        note("no surface is in view, so nothing was measured" + (why.empty() ? "" : ": " + why));
    } else if (truth.provesNothing()) {
        note("nothing in view of scene '" + scene + "' is " + (truth.lit == 0 ? "lit by" : "in the shadow of") + " '" +
             light + "', so this measurement proves nothing about shadows; choose another light, camera or scene");
    }
    // With more than one pixel in a thousand, the scene tests the rasteriser's rounding rather than shadows.
    if (truth.ties > truth.pixels / 1000)
        note(std::to_string(truth.ties) + " of " + std::to_string(truth.pixels) +
             " pixels are ties, more than one in a thousand: what lies there is not judged");
}

/// Judges every frame and times it; on a terminal a line says how far that is.
void measureAll(report::Measurement& measurement, const film::Motion& motion, const scene::Snapshot& base) {
    Progress progress("measuring: step", measurement.steps(motion.frames));
    int done = 0;
    progress.done(done);
    measurement.tell([&] {
        context::throwIfInterrupted();
        progress.done(++done);
    });
    for (int frame = 0; frame < motion.frames; ++frame)
        measurement.addFrame(film::momentAt(motion, base, frame));
    for (int turn = 0; turn < measurement.turns(); ++turn)
        measurement.timeTurn(turn);
    measurement.tell([] {});
}

int measure(const MeasureOptions& options) {
    std::unique_ptr<context::Context> context; // before all that lives in it, so that it is destroyed after them
    std::vector<picture::Slot> slots;
    for (const std::string& id : options.techniques) {
        slots.push_back(picture::Session::makeSlot(id));
        requireVisibility(*slots.back().info);
    }
    lab::applySettings(slots, options.settings);
    const scene::Snapshot base = loadSeenFrom(options.scene, options.view, loadOptions(options.allowed, options.normals));
    const int light = lightWithShadows(*base, options.scene, options.light, "measured");
    const film::Motion motion = motionOf(options.motion, *base);

    context = context::createContext(options.backend);
    requireDriverDraws(options.coverage.samples * options.size);
    picture::Session session(base);
    report::Measurement measurement(session, slots, light, options.size);
    measurement.askForCoverage(options.coverage);
    measureAll(measurement, motion, base);
    const Measured measured{
        base->name,   base->light(light).name, std::string(context->backend()), context::glRenderer(),
        options.size, motion.frames,           measurement.truthMs(),           measurement.coverageMs(), measurement.results()};
    for (const std::string& remark : base->notes)
        note(remark);
    for (const std::string& remark : lab::settingsWithoutEffect(slots))
        note(remark);
    sayWhatIsProved(measured.results.front().counts, film::momentAt(motion, base, 0), options.size, measured.scene,
                    measured.light);
    print(options.json ? measureJson(measured) : measureTable(measured, terminalColumns()));
    return 0;
}

Work measureWork(const GivenOptions& given) {
    return [options = measureOptions(given)] { return measure(options); };
}

} // namespace

std::vector<std::string> measuredTechniquesFrom(const std::vector<std::string>& texts) {
    std::vector<std::string> ids = splitAtCommas(texts);
    std::optional<TechniqueGroup> group;
    if (ids == std::vector<std::string>{"all"}) group = TechniqueGroup::production;
    if (ids == std::vector<std::string>{"lecture"}) group = TechniqueGroup::lecture;
    if (!group) return ids;
    ids.clear();
    for (const RegisteredTechnique& technique : techniquesOf(*group))
        if (publishes(*technique.info, kVisibilityStage)) ids.emplace_back(technique.info->id);
    return ids;
}

void reserveForMeasured(ivec2 size, int samples) {
    const std::uint64_t pixels = static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
    const auto onASide = static_cast<std::uint64_t>(samples);
    const std::string asked = "--size " + std::to_string(size.x) + "x" + std::to_string(size.y);
    if (samples == 1)
        return picture::reserveForPictures(pixels, picture::kBytesPerMeasuredPixel, asked, "choose a smaller --size");
    picture::reserveForPictures(pixels * (2 + onASide * onASide), picture::kBytesPerDrawnSample,
                                asked + " with --supersample " + std::to_string(samples),
                                "choose a smaller --size or --supersample");
}

const Command kMeasure{"measure", "SCENE",
                       "What techniques get wrong, pixel by pixel against the exact answer, and what they cost",
                       describeMeasure, measureWork};

} // namespace shadowlab::cli
