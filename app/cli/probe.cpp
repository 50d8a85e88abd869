// `shadowlab probe`: what a technique knows about one pixel.
// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "app/cli/json/probe_report.h"
#include "app/cli/messages.h"
#include "app/cli/probe_options.h"
#include "app/context/assets.h"
#include "app/drawing/paint.h"
#include "app/figures/figures.h"
#include "app/lab/settings.h"
#include "app/picture/limits.h"
#include "app/picture/session.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::cli {

namespace {

/// The bytes of the file.
std::vector<std::uint8_t> diagramOf(const ProbeOptions& options, const Probe& probe, const scene::Scene& scene,
                                    const View& view, int light) {
    const std::filesystem::path fonts = context::assetsRoot() / "fonts";
    const image::Font font(fonts / "DejaVuSans.ttf");
    const auto drawn = [&] {
        try {
            return figures::findFigure(options.figure).draw({probe, options.technique, scene, view, light, font});
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

} // namespace

int probe(const ProbeOptions& options) {
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot(options.technique));
    lab::applySettings(slots, options.settings);
    if (!options.diagram.empty()) image::probeWritable(options.diagram);
    const scene::Snapshot scene = scene::loadScene(
        options.scene, {.assetsRoot = context::assetsRoot(), .allowed = options.allowed, .limits = picture::limits()});
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
    print(options.json ? probeJson(probed) : probeText(probed));
    return 0;
}

} // namespace shadowlab::cli
