// `shadowlab judge`: another renderer's picture held against the truth.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/cli/json/judge_report.h"
#include "app/cli/measure.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/cli/text_table.h"
#include "app/context/assets.h"
#include "app/figures/figures.h"
#include "app/foreign/foreign_picture.h"
#include "app/picture/session.h"
#include "app/picture/verdict_panels.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"
#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::cli {

namespace {

struct JudgeOptions {
    std::filesystem::path picture;
    std::string scene;
    std::string light; ///< empty: the first
    std::filesystem::path reference, calibration; ///< empty: none
    std::optional<ivec2> size;                    ///< that the picture should have; none: any
    std::filesystem::path output;                 ///< a folder; empty: nothing is written
    bool byCentre = false;
    std::string view; ///< empty: the scene's own camera
    bool json = false;
    std::optional<scene::NormalMode> normals; ///< of a mesh; none: as it has them
    std::vector<std::filesystem::path> allowed;
};

constexpr int kFoundWanting = 1; // exit status: judged, and not all pixels are right

void describeJudge(DescribedOptions& add) {
    add.option("PICTURE", "PICTURE.png", "the picture that another program has drawn of the scene");
    describeScene(add);
    add.option("--light", "NAME", "the light whose shadows are judged (default: the first)");
    add.flag("--by-centre", "a light with an area is judged as a point at its centre, for a program that draws it so");
    add.option("--reference", "UNSHADOWED.png",
               "the same picture without shadows; without it PICTURE is a visibility image: 255 where the light is seen, 0 where not");
    add.option("--calibration", "CALIBRATION.png", "the calibration board that the same program has drawn: it is checked first");
    add.option("--size", "WxH", "the size that the picture should have (default: any)");
    add.option("-o,--output", "DIR",
               "a folder for errors.png, visibility.png (as it was found) and section.svg (at the first wrong pixel of the worst region); it is made where there is none");
    describeView(add);
    add.flag("--json", "one JSON object instead of text");
    describeNormals(add);
    add.option("--allow", "DIR", "a further folder that the scene may take meshes from; may be repeated");
    add.footer("Needs no graphics card.\n"
               "Ends with status 0 where no pixel is misjudged outside ties, with 1 where some are, and with 3 where the\n"
               "calibration is wrong: then nothing is judged.\n"
               "Examples:\n"
               "  shadowlab judge mine.png still-life --light key\n"
               "  shadowlab judge shaded.png still-life --reference unshadowed.png --calibration board.png -o found");
}

JudgeOptions judgeOptions(const GivenOptions& given) {
    const std::string example = "shadowlab judge PICTURE.png SCENE";
    JudgeOptions options;
    options.picture = given.required("PICTURE", example);
    options.scene = given.required("SCENE", example);
    options.light = given.text("--light");
    options.reference = given.text("--reference");
    options.calibration = given.text("--calibration");
    if (given.has("--size")) options.size = sizeFrom("--size", given.text("--size"), "measured-side");
    options.byCentre = given.has("--by-centre");
    options.output = given.text("--output");
    options.view = given.text("--view");
    options.json = given.has("--json");
    options.allowed = given.allowedFolders();
    options.normals = normalsFrom(given, options.scene);
    return options;
}

/// The picture's errors, each pixel as it is.
image::Image errorPicture(const image::Image& picture, const foreign::JudgedPicture& judged) {
    return picture::errorPanel(picture, judged.truth, judged.errors.judgement, {}).picture;
}

/// The scene with names that a figure can write: there a $ begins a formula.
scene::Snapshot withoutFormulas(const scene::Snapshot& scene) {
    auto plain = std::make_shared<scene::Scene>(*scene);
    for (scene::Light& light : plain->lights)
        std::ranges::replace(light.name, '$', ' ');
    for (scene::Object& object : plain->objects)
        std::ranges::replace(object.name, '$', ' ');
    return plain;
}

/// What a section shows, which is of a technique of this program, not of the picture's.
std::string sectionCaption(ivec2 pixel, const foreign::JudgedPicture& judged) {
    const bool isLit = judged.found.image.greyAlpha[2 * judged.truth.index(pixel.x, pixel.y)] > 127;
    return "pixel " + std::to_string(pixel.x) + "," + std::to_string(pixel.y) + " is " + (isLit ? "lit" : "dark") +
           " in the picture; the section shows how a technique of this program finds it " + (isLit ? "in shadow" : "lit");
}

/// The lecture's figure at that pixel, of the technique that shows the cause, and the caption below it. Throws Error where there is
/// nothing to draw.
std::string sectionAt(ivec2 pixel, const scene::Snapshot& named, int light, const foreign::JudgedPicture& judged) {
    const scene::Snapshot scene = withoutFormulas(named);
    const std::string_view technique = foreign::techniqueShowing(judged.diagnosis.causes.empty() ? "" : judged.diagnosis.causes.front().id);
    const picture::Slot slot = picture::Session::makeSlot(technique);
    View view;
    view.camera = scene->camera;
    view.size = judged.truth.size;
    view.picked = pixel;
    const Probe probe = slot.technique->probe(scene, view, pixel, light);
    const std::filesystem::path fonts = context::assetsRoot() / "fonts";
    const image::Font font(fonts / "DejaVuSans.ttf"), bold(fonts / "DejaVuSans-Bold.ttf");
    figures::Diagram figure = figures::findFigure("pixel").draw({probe, technique, *scene, view, light, font, bold});
    constexpr double kType = 26, kMargin = 24; // pixels of the sheet: as large as the figure's own words
    for (const std::string& line : font.wrap(sectionCaption(pixel, judged), kType, static_cast<int>(figure.drawing.size().x - 2 * kMargin))) {
        figure.drawing.addRoomBelow(1.4 * kType);
        figure.drawing.text({kMargin, figure.drawing.size().y - 0.6 * kType}, line, {.size = kType, .color = "#1a1a1a", .hasRim = false});
    }
    return figure.document();
}

void writeFindings(const JudgeOptions& options, const image::Image& picture, const scene::Snapshot& scene, int light, JudgeReport& report) {
    const foreign::JudgedPicture& judged = *report.judged;
    image::makeFolders(options.output);
    const auto write = [&](const char* name, const auto& bytes, std::string& written) {
        const std::filesystem::path file = options.output / name;
        image::writeWhole(file, bytes);
        written = file.string();
    };
    write("errors.png", image::encodePng(errorPicture(picture, judged)), report.errorPicture);
    const picture::VisibilityImage& found = judged.found.image;
    write("visibility.png", image::encodeGreyAlpha(found.width, found.height, found.greyAlpha), report.visibilityPicture);
    if (!judged.diagnosis.region) return;
    std::string document;
    try {
        document = sectionAt(judged.diagnosis.region->firstWrong, scene, light, judged);
    } catch (const Error& why) {
        report.sectionRemark = why.what();
        return;
    }
    write("section.svg", document, report.section);
    report.sectionCaption = sectionCaption(judged.diagnosis.region->firstWrong, judged);
}

int judgePicture(const JudgeOptions& options) {
    const image::Image picture = foreign::loadForeign(options.picture);
    const ivec2 size(picture.width, picture.height);
    if (options.size) foreign::requireSameSize(picture, options.picture, *options.size, "--size");
    reserveForMeasured(size);
    std::optional<image::Image> reference, board;
    if (!options.reference.empty()) {
        reference = foreign::loadForeign(options.reference);
        foreign::requireSameSize(*reference, options.reference, size, scene::shownPath(options.picture));
    }
    if (!options.calibration.empty()) board = foreign::loadForeign(options.calibration);
    for (const std::filesystem::path& file : {options.picture, options.reference, options.calibration})
        if (!file.empty()) image::keepInput(file);
    const scene::Snapshot scene = loadSeenFrom(options.scene, options.view, loadOptions(options.allowed, options.normals));
    const int light = lightWithShadows(*scene, options.scene, options.light, "judged");
    for (const std::string& remark : scene->notes)
        note(remark);

    JudgeReport report;
    report.picture = options.picture.string();
    report.reference = options.reference.string();
    report.calibrationFile = options.calibration.string();
    report.scene = scene->name;
    report.light = scene->light(light).name;
    report.size = size;
    if (board) {
        report.calibration = foreign::readCalibration(*board, scene->camera, size);
        if (!report.calibration->isRight()) {
            print(options.json ? judgeJson(report) : judgeText(report, terminalColumns()));
            const foreign::FoundFault& first = report.calibration->faults.front();
            throw Error(ExitStatus::badInput, scene::shownPath(options.calibration) + ": the calibration " + first.what + "; " + first.remedy);
        }
    }
    try {
        const judge::TruthOf truthOf = options.byCentre ? judge::TruthOf::centre : foreign::truthOfLight(scene->light(light));
        report.judged = foreign::judgePicture(scene, light, truthOf, picture, reference ? &*reference : nullptr);
    } catch (const Error& why) {
        throw Error(why.status(), scene::shownPath(options.picture) + ": " + why.what());
    }
    if (!options.output.empty()) writeFindings(options, picture, scene, light, report);
    const judge::Counts& counts = report.judged->errors.judgement.counts;
    if (counts.provesNothing())
        note("nothing in view of scene '" + scene->name + "' is " + (counts.lit == 0 ? "lit by" : "in the shadow of") + " '" + report.light +
             "', so this picture proves nothing about shadows; choose another light, camera or scene");
    print(options.json ? judgeJson(report) : judgeText(report, terminalColumns()));
    return report.judged->isRight() ? 0 : kFoundWanting;
}

Work judgeWork(const GivenOptions& given) {
    return [options = judgeOptions(given)] { return judgePicture(options); };
}

} // namespace

const Command kJudge{"judge", "PICTURE.png SCENE", "Holds another renderer's picture against the truth, and says what its errors look like", describeJudge, judgeWork};

} // namespace shadowlab::cli
