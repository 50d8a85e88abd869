// `shadowlab probe`: how a technique decided about one pixel.
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/cli/json/probe_report.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/cli/text_table.h"
#include "app/context/assets.h"
#include "app/drawing/paint.h"
#include "app/figures/figures.h"
#include "app/lab/old_spelling.h"
#include "app/lab/settings.h"
#include "app/picture/session.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/math/types.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::cli {

namespace {

struct ProbeOptions {
    std::string scene;
    ivec2 pixel{0};               ///< column and row, from the upper left corner
    std::optional<ivec2> partner; ///< a second one
    std::string technique = "shadow-volume-zfail";
    ivec2 size{1280, 720};
    std::vector<std::string> settings; ///< [SLOT:]ID.PARAM=VALUE
    std::string light;                 ///< empty: the first
    bool json = false;
    std::filesystem::path diagram; ///< empty: none
    std::string figure = "pixel";  ///< what is drawn there (figures/figures.h)
    std::string view; ///< empty: the scene's own camera
    std::optional<scene::NormalMode> normals; ///< of a mesh; none: as it has them
    std::vector<std::filesystem::path> allowed;
};

void describeProbe(DescribedOptions& add) {
    describeScene(add);
    add.option("--pixel", "X,Y", "column and row of the pixel, counted from 0 at the upper left corner");
    add.option(
        "--partner", "X,Y",
        "a second pixel: radiosity tells what its patch and the first one's send each other; other techniques take no "
        "notice");
    add.option("-t,--technique", "ID", "the technique that is asked (`list techniques`; default shadow-volume-zfail)");
    add.option("--size", "WxH",
               "width and height in pixels of the picture that the pixel belongs to (default 1280x720)");
    add.option("--set", "ID.PARAM=VALUE", "a parameter (`list parameters`); may be repeated");
    add.option("--light", "NAME", "the light that is asked about (default: the first)");
    describeView(add);
    add.flag("--json", "one JSON object instead of lines");
    add.option(
        "--diagram", "OUT",
        "draws the lecture's figure from that pixel: faces of shadow volumes and their counts, texels of a shadow map, "
        "or a projected shadow, in the plane through eye, light and point; of ray tracing the pixel's rays and their "
        "tree; of radiosity two patches with the angles of their form factor. OUT ends in .svg, or in .png for a "
        "picture");
    add.option("--figure", "NAME",
               "which figure --diagram draws (`list figures`; default pixel, all that the technique has)");
    describeNormals(add);
    add.option("--allow", "DIR", "a further folder that the scene may take meshes from; may be repeated");
    add.footer("Needs no graphics card.\n"
               "Examples:\n"
               "  shadowlab probe still-life --pixel 640,360\n"
               "  shadowlab probe still-life --pixel 700,420 -t shadow-volume --diagram count.svg\n"
               "  shadowlab probe mirror-and-glass --pixel 500,420 -t ray-traced --diagram tree.svg\n"
               "  shadowlab probe cornell-room --pixel 500,690 --partner 300,400 -t radiosity --diagram pair.svg\n"
               "  shadowlab probe still-life --pixel 640,360 -t shadow-map --set shadow-map.resolution=512 --json");
}

/// Is the diagram wanted as a picture, not as SVG?
bool isPicture(const std::filesystem::path& diagram) { return diagram.extension() == ".png"; }

/// A drawing or a picture; who writes x.jpg wants a picture.
void requireDiagramEnding(const std::filesystem::path& diagram) {
    const std::string ending = diagram.extension().string();
    if (endsAsPicture(diagram) && ending != ".svg" && ending != ".png")
        refuseUsage("--diagram: '" + diagram.string() + "' ends neither in .svg nor in .png; write " +
                    std::filesystem::path(diagram).replace_extension(".png").string());
    requireEnding("--diagram", diagram, isPicture(diagram) ? ".png" : ".svg");
}

ProbeOptions probeOptions(const GivenOptions& given) {
    const std::string example = "shadowlab probe SCENE --pixel X,Y";
    ProbeOptions options;
    options.scene = given.required("SCENE", example);
    options.size = sizeFrom("--size", given.text("--size", "1280x720"), "picture-side");
    options.pixel = pixelFrom("--pixel", given.required("--pixel", example), options.size);
    if (given.has("--partner")) options.partner = pixelFrom("--partner", given.text("--partner"), options.size);
    std::vector<std::string> techniques =
        given.has("--technique") ? splitAtCommas(given.texts("--technique")) : std::vector{options.technique};
    if (techniques.size() != 1) refuseUsage("-t: one technique is asked at a time; write it alone");
    options.settings = given.texts("--set");
    lab::respell(techniques, {}, options.settings);
    options.technique = techniques.front();
    options.light = given.text("--light");
    options.view = given.text("--view");
    options.json = given.has("--json");
    options.diagram = given.text("--diagram");
    if (!options.diagram.empty()) requireDiagramEnding(options.diagram);
    if (given.has("--figure") && options.diagram.empty())
        refuseUsage("--figure is drawn into a file; write --diagram OUT.svg or OUT.png, too");
    options.figure = figures::findFigure(given.text("--figure", options.figure)).name;
    options.allowed = given.allowedFolders();
    options.normals = normalsFrom(given, options.scene);
    return options;
}

/// The bytes of the file.
std::vector<std::uint8_t> diagramOf(const ProbeOptions& options, const Probe& probe, const scene::Scene& scene,
                                    const View& view, int light) {
    const std::filesystem::path fonts = context::assetsRoot() / "fonts";
    const image::Font font(fonts / "DejaVuSans.ttf"), bold(fonts / "DejaVuSans-Bold.ttf");
    const auto drawn = [&] {
        try {
            return figures::findFigure(options.figure).draw({probe, options.technique, scene, view, light, font, bold});
        } catch (const Error& why) {
            throw Error(ExitStatus::usage, std::string("--diagram: ") + why.what()); // the pixel was given there
        }
    }();
    if (!isPicture(options.diagram)) {
        const std::string document = drawn.document();
        return {document.begin(), document.end()};
    }
    const ivec2 size(glm::ceil(drawn.drawing.size()));
    image::Image picture(size.x, size.y, {255, 255, 255, 255});
    drawing::Painter(fonts).paint(drawn.drawing, picture);
    return image::encodePng(picture, {.opaque = true, .text = {}});
}

int probe(const ProbeOptions& options) {
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot(options.technique));
    lab::applySettings(slots, options.settings);
    if (!options.diagram.empty()) image::probeWritable(options.diagram);
    const scene::Snapshot scene = loadSeenFrom(options.scene, options.view, loadOptions(options.allowed, options.normals));
    int light = scene->lights.empty() ? kNoLight : 0;
    if (!options.light.empty()) light = picture::lightIndex(*scene, options.light);
    View view;
    view.camera = scene->camera;
    view.size = options.size;
    view.picked = options.pixel;
    view.partner = options.partner;
    const ProbedPixel probed{scene->name,
                             options.technique,
                             light < 0 ? "" : scene->light(light).name,
                             options.size,
                             options.pixel,
                             options.partner,
                             slots.front().technique->probe(scene, view, options.pixel, light)};
    if (!options.diagram.empty())
        image::writeWhole(options.diagram, diagramOf(options, probed.probe, *scene, view, light));
    for (const std::string& remark : scene->notes)
        note(remark);
    for (const std::string& remark : lab::settingsWithoutEffect(slots))
        note(remark);
    if (light < 0) note("scene '" + scene->name + "' has no lights; there is no shadow to ask about");
    print(options.json ? probeJson(probed) : fitting(probeText(probed), terminalColumns()));
    return 0;
}

Work probeWork(const GivenOptions& given) {
    return [options = probeOptions(given)] { return probe(options); };
}

} // namespace

const Command kProbe{"probe", "SCENE",
                     "What a technique knows about one pixel: facts, vectors, and the tree of its rays", describeProbe,
                     probeWork};

} // namespace shadowlab::cli
