// "Motion blur": where a moving object is at the times at which the pixel's rays are sent, as the camera sees it, and what each of
// them brings.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/figures/figure_drawers.h"
#include "app/figures/figure_parts.h"
#include "app/figures/panels.h"
#include "app/figures/parallel_view.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/look.h"
#include "techniques/probed/rays_probe.h"

namespace shadowlab::figures {

namespace {

constexpr double kAxisHeight = 190, kInstantSwatch = 96, kSwatchColumn = 200; ///< pixels

/// Pixels of the picture.
class PictureOf {
public:
    PictureOf(const scene::Camera& camera, ivec2 size)
        : clipFromWorld_(scene::clipFromView(camera, static_cast<double>(size.x) / size.y) *
                         scene::viewFromWorld(camera)),
          size_(size) {}
    [[nodiscard]] bool isBefore(const dvec3& positionWorld) const {
        return (clipFromWorld_ * dvec4(positionWorld, 1)).w > 0;
    }
    [[nodiscard]] dvec2 operator()(const dvec3& positionWorld) const {
        const dvec4 clip = clipFromWorld_ * dvec4(positionWorld, 1);
        return 0.5 * dvec2(size_) * dvec2(1 + clip.x / clip.w, 1 - clip.y / clip.w);
    }

private:
    dmat4 clipFromWorld_;
    ivec2 size_;
};

/// The mover that most of the rays meet.
const scene::Object& moverOf(const FigureSource& source, const RaysProbe& rays) {
    const scene::Object* best = nullptr;
    std::ptrdiff_t most = 0;
    for (const scene::Object& object : source.scene.objects) {
        if (object.velocityWorld == dvec3(0)) continue;
        const auto count = std::ranges::count(rays.samples, object.name, &RaysProbe::Sample::object);
        if (count <= most) continue;
        most = count;
        best = &object;
    }
    if (!best || rays.shutter <= 0)
        throw Error(ExitStatus::badInput,
                    rays.shutter <= 0 ? "the shutter is open for no time; set ray-traced.shutter, for example to 1"
                                      : "nothing that moves crosses the pixel; choose one at the edge of an "
                                        "object that has a velocity");
    return *best;
}

std::vector<dvec2> outlineAt(const scene::Object& object, double time, const scene::Camera& camera,
                             const PictureOf& picture) {
    const dvec3 moved = time * object.velocityWorld;
    std::vector<dvec2> segments;
    const std::vector<dvec3> edges = drawnEdgesWorld(object, dvec4(camera.positionWorld - moved, 1));
    for (std::size_t i = 0; i + 1 < edges.size(); i += 2)
        if (picture.isBefore(edges[i] + moved) && picture.isBefore(edges[i + 1] + moved))
            segments.insert(segments.end(), {picture(edges[i] + moved), picture(edges[i + 1] + moved)});
    return segments;
}

/// When each ray is sent, and what it brings.
void drawTimes(drawing::Drawing& drawing, const drawing::Box& area, const FigureSource& source, const RaysProbe& rays) {
    const double exposure = static_cast<double>(source.scene.exposure);
    const double y = area.corner.y + 62;
    const double left = area.corner.x + 30, right = area.corner.x + area.size.x - kSwatchColumn - 60;
    const auto at = [&](double time) { return dvec2(glm::mix(left, right, time / rays.shutter), y); };
    drawing.text({area.corner.x, area.corner.y + kText - 4}, "What the ray of each time brings",
                 {.size = kText, .isBold = true});
    drawing.arrow({left - 10, y}, {right + 36, y}, {"#1a1a1a", 3, false});
    const double radius = std::clamp(0.32 * (right - left) / static_cast<double>(rays.samples.size()), 5.0, 20.0);
    for (const RaysProbe::Sample& sample : rays.samples)
        drawing.circle(at(sample.time), radius, shownColor(sample.intensity, exposure), {"#1a1a1a", 2.5, false},
                       "sample");
    drawing.text({left, y + 60}, "time 0", {.size = kText, .anchor = drawing::Anchor::start});
    drawing.text({right, y + 60}, "shutter closes, " + fourDigits(rays.shutter),
                 {.size = kText, .anchor = drawing::Anchor::end});
    const dvec2 swatch(area.corner.x + area.size.x - kSwatchColumn + 40, area.corner.y + 10);
    drawing.rectangle(swatch, dvec2(kInstantSwatch), shownColor(rays.mean(), exposure), {"#1a1a1a", 3, false});
    drawing.text(swatch + dvec2(0, kInstantSwatch + 1.3 * kText), "their mean", {.size = kText, .isBold = true});
}

} // namespace

Diagram drawShutter(const FigureSource& source) {
    eyeRayOf(source);
    const RaysProbe& rays = samplesOf(source);
    const scene::Object& mover = moverOf(source, rays);
    const PictureOf picture(source.view.camera, source.view.size);
    drawing::Drawing drawing(source.size);
    const auto hits =
        static_cast<std::size_t>(std::ranges::count(rays.samples, mover.name, &RaysProbe::Sample::object));
    const drawing::Box room = writeFoot(drawing, roomOf(source),
                               mover.name + " at the times of the " + std::to_string(rays.samples.size()) +
                                   " rays, as the camera sees it: dark at first, light at last. " +
                                   counted(hits, "ray meets it.", "rays meet it."),
                               source.font);
    const drawing::Box figure{room.corner, room.size - dvec2(0, kAxisHeight)};
    std::vector<const RaysProbe::Sample*> byTime;
    for (const RaysProbe::Sample& sample : rays.samples)
        byTime.push_back(&sample);
    std::ranges::stable_sort(byTime, {}, &RaysProbe::Sample::time);
    dvec2 low(1e300), high(-1e300);
    std::vector<std::vector<dvec2>> outlines;
    for (const RaysProbe::Sample* sample : byTime) {
        outlines.push_back(outlineAt(mover, sample->time, source.view.camera, picture));
        for (const dvec2& at : outlines.back()) {
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
    }
    const dvec2 pixel = dvec2(source.view.picked.value_or(ivec2(0))) + 0.5;
    low = glm::min(low, pixel);
    high = glm::max(high, pixel);
    const dvec2 margin(60, 44);
    const double scale =
        std::min((figure.size.x - 2 * margin.x) / (high.x - low.x), (figure.size.y - 2 * margin.y) / (high.y - low.y));
    const dvec2 offset = figure.corner + 0.5 * figure.size - 0.5 * scale * (low + high);
    drawing::Labels labels(source.fonts(), figure);
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        for (dvec2& at : outlines[i])
            at = offset + scale * at;
        const double share = byTime[i]->time / rays.shutter;
        drawing.segments(outlines[i], {drawing::colorText(look::colorAt(look::viridis(), 0.9 * share)), 3, false});
    }
    for (const std::vector<dvec2>& outline : outlines)
        for (std::size_t i = 0; i + 1 < outline.size(); i += 2)
            labels.avoid(outline[i], outline[i + 1]);
    // Its way, from the first of these times to the last.
    const scene::Bounds box = scene::boundsWorld(mover);
    const dvec3 centre = 0.5 * (box.lowerWorld + box.upperWorld);
    const dvec2 from = offset + scale * picture(centre + byTime.front()->time * mover.velocityWorld),
                to = offset + scale * picture(centre + byTime.back()->time * mover.velocityWorld);
    drawing.arrow(from, to, {"#1a1a1a", 4, false});
    labels.avoid(from, to);
    const dvec2 at = offset + scale * pixel;
    const double half = std::max(9.0, 0.5 * scale);
    drawing.rectangle(at - half, dvec2(2 * half), "", {"#ffffff", 8, false});
    drawing.rectangle(at - half, dvec2(2 * half), "", {drawing::colorText(look::kOccluded), 5, false});
    labels.avoid({at - half - 4.0, dvec2(2 * half + 8)});
    labels.place(drawing, at, "the pixel", {.size = kText, .isBold = true}, half + 10);
    labels.place(drawing, 0.5 * (from + to), "its way", {.size = kText}, 10);
    drawTimes(drawing, {room.corner + dvec2(0, room.size.y - kAxisHeight), {room.size.x, kAxisHeight}}, source, rays);
    return {std::move(drawing),
            "A moving object at the times at which a pixel's rays are sent, and what each ray brings"};
}

} // namespace shadowlab::figures
