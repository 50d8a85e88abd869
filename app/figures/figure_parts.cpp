// SPDX-License-Identifier: MIT
#include "app/figures/figure_parts.h"

#include "app/figures/panels.h"
#include "techniques/foundation/base/error.h"
#include "techniques/probed/rays_probe.h"

namespace shadowlab::figures {

namespace {

[[noreturn]] void refuse(const std::string& why) { throw Error(ExitStatus::badInput, why); }

} // namespace

drawing::Box roomOf(const FigureSource& source) { return {dvec2(kFigureBorder), source.size - 2 * kFigureBorder}; }

const Probe::Segment& eyeRayOf(const FigureSource& source) {
    if (source.probe.geometry.empty() || source.probe.geometry.front().isEndless)
        refuse("the pixel shows the background; choose another");
    return source.probe.geometry.front();
}

const std::vector<Probe::Node>& treeOf(const FigureSource& source) {
    eyeRayOf(source);
    if (source.probe.tree.empty())
        refuse(std::string(source.technique) + " has no tree of rays to draw; ask ray-traced");
    return source.probe.tree;
}

const RaysProbe& samplesOf(const FigureSource& source) {
    if (source.technique != "ray-traced")
        refuse(std::string(source.technique) + " sends no rays to draw; ask ray-traced");
    if (!source.probe.find<RaysProbe>())
        refuse("with one ray for the pixel nothing is spread; set ray-traced.samples, for example to 16");
    return *source.probe.find<RaysProbe>();
}

const scene::Light& areaLightOf(const FigureSource& source) {
    if (source.light < 0) refuse("scene '" + source.scene.name + "' has no lights; choose another scene");
    const scene::Light& light = source.scene.light(source.light);
    if (!scene::hasArea(light))
        refuse("light '" + light.name + "' has no area; choose a rect or a sphere, or a scene that has one");
    return light;
}

std::string shownColor(const dvec3& intensity, double exposure) {
    return drawing::colorText(vec3(glm::clamp(exposure * intensity, 0.0, 1.0)));
}

drawing::Stroke thinStroke(const std::string& color) { return {color, 2, false}; }

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

drawing::Box writeFoot(drawing::Drawing& drawing, const drawing::Box& room, const std::string& text, const image::Font& font) {
    constexpr double kRow = 1.25 * kText;
    const std::vector<std::string> lines = font.wrap(text, kText, static_cast<int>(room.size.x));
    const double height = kRow * static_cast<double>(lines.size());
    double foot = room.corner.y + room.size.y - height + kText;
    for (const std::string& line : lines) {
        drawing.text({room.corner.x, foot}, line, {.size = kText, .color = "#4d4d4d"});
        foot += kRow;
    }
    return {room.corner, {room.size.x, room.size.y - height - 10}};
}

} // namespace shadowlab::figures
